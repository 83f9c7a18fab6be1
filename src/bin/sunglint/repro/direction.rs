//! A direction again.

use sunglint::Real;
use sunglint::oracle::{angle_between, nearest_in_disc};
use sunglint::trial::lights::BUDGETED;
use sunglint::trial::{Constants, Format, Light, Method, Visitor, budget};

use crate::number::shortest;

use super::{in_radii, lanes, measures, used};

/// A method's input in a format under a light.
#[derive(Clone, Copy, Debug)]
pub struct Direction {
    /// The method.
    pub method: Method,
    /// The format.
    pub format: Format,
    /// The light.
    pub light: Light,
    /// Direction to the light.
    pub l: [f64; 3],
    /// Mirror direction.
    pub r: [f64; 3],
}

/// What came of it.
#[derive(Clone, Copy, Debug)]
pub struct Computed {
    /// What the format answers.
    answer: [f64; 3],
    /// The exact value of the method's formula.
    truth: [f64; 3],
    /// The nearest point of the disc.
    nearest: [f64; 3],
    /// Arithmetic error in radians; NaN where the answer is no direction.
    pub error: f64,
    /// Model error in radians.
    model: f64,
    /// Both together in radians.
    total: f64,
}

/// The answer in the format.
struct Answer<'a>(&'a Direction);

impl Visitor for Answer<'_> {
    type Output = [f64; 3];

    fn visit<T: Real>(self) -> [f64; 3] {
        let Direction { method, light, l, r, .. } = self.0;
        let [l, r] = [l, r].map(|vector| vector.map(T::from_f64));
        method.direction(l, r, &Constants::<T>::of(&light.light)).map(T::to_f64)
    }
}

impl Direction {
    /// Answer, truth and errors.
    pub fn computed(&self) -> Computed {
        let Self { method, format, light: Light { light, .. }, l, r } = *self;
        let answer = format.visit(Answer(self));
        let (truth, nearest) = (method.truth(l, r, &light), nearest_in_disc(l, r, light.angular_radius()));
        // The zero vector has no direction, in which no angle is to be found.
        let directed = answer.into_iter().all(f64::is_finite) && answer != [0.0; 3];
        let [error, total] =
            [truth, nearest].map(|exact| if directed { angle_between(answer, exact) } else { f64::NAN });
        Computed { answer, truth, nearest, error, model: angle_between(truth, nearest), total }
    }

    /// All there is to say.
    pub fn text(&self) -> String {
        let Self { method, format, light: Light { name, light }, l, r } = *self;
        let Computed { answer, truth, nearest, error, model, total } = self.computed();
        let mut table = lanes::table();
        lanes::add(&mut table, "l, to the light", format, l);
        lanes::add(&mut table, "r, mirror direction", format, r);
        lanes::add(&mut table, "answer", format, answer);
        lanes::add_truth(&mut table, "truth of the same formula", truth);
        lanes::add_truth(&mut table, "nearest point of the disc", nearest);
        let [step, apart] = [format.step(), angle_between(l, r)];
        let lines = [
            format!("{} in {} under {name}: {}\n", method.name(), format.name(), measures(&light)),
            format!("{}\n", table.trim_fmt()),
            format!("from l to r       {} rad{}", shortest(apart), in_radii(apart, &light)),
            format!(
                "arithmetic error  {} rad, {:.3} steps of {} below 1",
                shortest(error),
                error / step,
                format.name()
            ),
            format!("model error       {} rad{}", shortest(model), in_radii(model, &light)),
            format!("total error       {} rad{}", shortest(total), in_radii(total, &light)),
            used(error, self.budget(), " rad"),
            self.left_out().to_owned(),
        ];
        lines.join("\n").trim_end().to_owned()
    }

    /// The arithmetic error that the tests of the library allow.
    fn budget(&self) -> Option<f64> {
        let Self { method, format, light: Light { light, .. }, .. } = *self;
        match BUDGETED.iter().position(|known| known.light == light) {
            Some(place) => budget::maximum(method, format, place),
            // With a distance of its own it may overflow.
            None if method == Method::Epic && light.distance() != 1.0 => None,
            None => budget::of_any_light(method, format, light.angular_radius()),
        }
    }

    /// Why the study does not judge it, if it does not.
    fn left_out(&self) -> &'static str {
        let Self { method, format, light: Light { light, .. }, l, r } = *self;
        match method {
            _ if method.is_defined(l, r, &light, format.step()) => "",
            Method::Epic | Method::Factored => "left out of the study: the representative point falls into the origin",
            Method::Disc | Method::Cap => {
                "left out of the study: beside the opposite of the light all of the rim is as near"
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use sunglint::DistantLight;
    use sunglint::trial::worst;

    fn of(method: Method, light: DistantLight, [l, r]: [[f64; 3]; 2]) -> Direction {
        Direction { method, format: Format::F32, light: Light { name: "light", light }, l, r }
    }

    #[test]
    fn what_a_search_found_is_within_its_budget() {
        for method in [Method::Factored, Method::Disc, Method::Cap] {
            for (place, known) in BUDGETED.iter().enumerate() {
                let pair = worst::under(method, Format::F32, place).next().expect("a record");
                let direction = of(method, known.light, [pair.l, pair.r]);
                let share = direction.computed().error / direction.budget().expect("a budget");
                assert!((0.5..=1.0).contains(&share), "{} under {}: {share}", method.name(), known.name);
                assert!(direction.text().contains(" %"));
            }
        }
    }

    #[test]
    fn what_the_study_leaves_out_is_said() {
        let opposite = [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
        let text = of(Method::Cap, sunglint::SUN, opposite).text();
        assert!(text.contains("left out of the study"), "{text}");
        let aside = of(Method::Cap, sunglint::SUN, [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0]]).text();
        assert!(!aside.contains("left out") && aside.contains("337.7"), "{aside}");
    }
}
