use sunglint::oracle::highlight::*;
use sunglint::oracle::quadrature::*;
use sunglint::trial::*;
use sunglint::*;
fn pix(theta: f64, alpha: f64, rng: &mut oorandom::Rand64) -> Pixel {
    let inc = rng.rand_float() * 75f64.to_radians();
    let l = [inc.sin(), 0.0, inc.cos()];
    let up = [inc.cos(), 0.0, -inc.sin()];
    let ps = (theta + 2.0 * alpha) * 10f64.powf(-2.0 + 3.0 * rng.rand_float());
    let ps = ps.min(1.0);
    let az = rng.rand_float() * std::f64::consts::TAU;
    let r = [0, 1, 2].map(|i| ps.cos() * l[i] + ps.sin() * (az.cos() * up[i] + az.sin() * [0.0, 1.0, 0.0][i]));
    let v = [-r[0], -r[1], r[2]];
    Pixel { n: [0.0, 0.0, 1.0], v, l }
}
#[test]
fn scratch() {
    let q = Quadrature::<12>::new();
    let alphas = [0.0, 5e-4, 2e-3, 8e-3, 0.0625, 0.25, 1.0];
    for x in [0.00465, 0.05] {
        for alpha in alphas {
            for inc in [0.0f64, 60.0, 80.0] {
                let g = Glossy { alpha, f0: 0.04, ratio: x };
                let l = q.lobes(&g, inc.to_radians(), |p| Shading::ALL.map(|m| m.truth(&g, p)));
                let sphere = DistantSphere::<f64>::of(&DistantLight::from_ratio(x).unwrap());
                let k = q.lobes(&g, inc.to_radians(), |p| {
                    Shading::ALL.map(|m| m.radiance::<f64>(&g, &sphere, [p.n, p.v, p.l]))
                });
                print!("{x} {alpha:8} {inc:3} {:.5} L1", l[0].truth);
                for a in &l {
                    print!(" {:8.4}", a.relative_l1);
                }
                print!(" | ");
                for a in &k {
                    print!(" {:8.4}", a.relative_l1);
                }
                println!();
            }
        }
    }
}
fn each<T: Real>() {
    for (x, alpha) in [(0.00465, 0.002), (0.00465, 0.0625), (0.00465, 0.25), (0.05, 0.01), (0.3, 0.1), (0.0, 0.01)] {
        let mut rng = oorandom::Rand64::new(3);
        let light = DistantLight::from_ratio(x).unwrap();
        let sphere = DistantSphere::<T>::of(&light);
        let mut worst = [0.0f64; 8];
        let mut sum = [0.0; 8];
        let n = 20000;
        for _ in 0..n {
            let p = pix(light.angular_radius(), alpha, &mut rng);
            if p.v[2] < 0.02 {
                continue;
            }
            let t = [p.n, p.v, p.l].map(|v| v.map(T::from_f64));
            let e = t.map(|v| v.map(T::to_f64));
            let al = T::Scalar::nearest(alpha).exact();
            let g = Glossy {
                alpha: al,
                f0: T::Scalar::nearest(0.04).exact(),
                ratio: if T::NAME == "f16" { T::from_f64(x).to_f64() } else { x },
            };
            let px = Pixel { n: e[0], v: e[1], l: e[2] };
            for (i, m) in Shading::ALL.into_iter().enumerate() {
                let truth = m.truth(&g, &px) + 0.2 / std::f64::consts::PI * px.unit().l[2];
                let got = m.radiance::<T>(&g, &sphere, t) + 0.2 / std::f64::consts::PI * px.unit().l[2];
                let er = (got / truth - 1.0).abs();
                if !(er <= worst[i]) {
                    worst[i] = er;
                }
                sum[i] += er * er;
            }
        }
        print!("{:>9} x {x} alpha {alpha:6}: ", T::NAME);
        for i in 0..8 {
            print!(" {:.1e}/{:.1e}", worst[i], (sum[i] / n as f64).sqrt());
        }
        println!();
    }
}
#[test]
fn formats() {
    each::<f64>();
    each::<f32>();
    each::<micromath::F32>();
    each::<half::f16>();
    each::<fixed::types::I2F14>();
    each::<fixed::types::I2F30>();
    each::<fixed::types::I16F16>();
}
