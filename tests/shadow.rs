//! Soft shadows against areas on the sphere, in every format.

mod exact;

use sunglint::trial::shadow::{self as trial, COUNTS, Occluder};
use sunglint::trial::{Format, Visitor};
use sunglint::{DistantLight, Real, SUN};

#[test]
#[ignore = "the budgets"]
fn budgets() {
    struct Long;
    impl Visitor for Long {
        type Output = ();
        fn visit<T: Real>(self) {
            for (name, light) in [("Sun", SUN), ("0.05", DistantLight::from_ratio(0.05).unwrap()), ("0.5", DistantLight::from_ratio(0.5).unwrap())] {
                for occluder in Occluder::ALL {
                    let all = COUNTS.map(|count| {
                        let scenes = if count > 5000 { 40 } else { 400 };
                        let found = trial::error::<T>(&light, occluder, count, 1, scenes);
                        let scale = f64::from(count).powf(0.75);
                        format!("{:.1e} ({:.2}) rms {:.1e}", found.max, found.max * scale, found.rms())
                    });
                    println!("{} {name} {occluder:?}: {all:?}", T::NAME);
                }
            }
        }
    }
    Format::ALL.into_iter().for_each(|format| format.visit(Long));
}
