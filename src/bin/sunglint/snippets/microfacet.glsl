// What highlights share, from sunglint 0.1.0, MIT OR Apache-2.0.

// Height-correlated Smith visibility times n.l (Heitz, 2014): cosines above 0, alpha from 0 to 1.
float smith(float n_dot_l, float n_dot_v, float alpha) {
    float a = alpha * alpha;
    float toward_light = sqrt(a + (1.0 - a) * (n_dot_l * n_dot_l));
    float toward_viewer = sqrt(a + (1.0 - a) * (n_dot_v * n_dot_v));
    return 0.5 / (toward_viewer + n_dot_v * (toward_light / n_dot_l));
}

// Reflectance (Schlick, 1994), from f0 at normal incidence.
vec3 schlick(vec3 f0, float v_dot_h) {
    float rest = max(1.0 - v_dot_h, 0.0);
    float square = rest * rest;
    return f0 + (1.0 - f0) * (square * square * rest);
}

// What of the normal is across the half vector: its square is 1 - (n.h)^2, of which a subtraction would lose digits.
vec3 lean(vec3 n, vec3 h) {
    vec3 apart = n - h;
    return apart - dot(apart, h) * h;
}
