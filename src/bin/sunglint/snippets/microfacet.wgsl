// What highlights share, from sunglint 0.1.0, MIT OR Apache-2.0.

// Height-correlated Smith visibility times n.l (Heitz, 2014): cosines above 0, alpha from 0 to 1.
fn smith(n_dot_l: f32, n_dot_v: f32, alpha: f32) -> f32 {
    let a = alpha * alpha;
    let toward_light = sqrt(a + (1.0 - a) * (n_dot_l * n_dot_l));
    let toward_viewer = sqrt(a + (1.0 - a) * (n_dot_v * n_dot_v));
    return 0.5 / (toward_viewer + n_dot_v * (toward_light / n_dot_l));
}

// Reflectance (Schlick, 1994), from f0 at normal incidence.
fn schlick(f0: vec3f, v_dot_h: f32) -> vec3f {
    let rest = max(1.0 - v_dot_h, 0.0);
    let square = rest * rest;
    return f0 + (1.0 - f0) * (square * square * rest);
}

// What of the normal is across the half vector: its square is 1 - (n.h)^2, of which a subtraction would lose digits.
fn lean(n: vec3f, h: vec3f) -> vec3f {
    let apart = n - h;
    return apart - dot(apart, h) * h;
}
