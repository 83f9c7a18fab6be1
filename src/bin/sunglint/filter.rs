//! Which methods, number formats, lights and roughnesses are measured.

use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use sunglint::material::{Material, MaterialError};
use sunglint::trial::gloss::{CASES, Case};
use sunglint::trial::quantity::Quantity;
use sunglint::trial::{Format, Light, Method, Shading, chip, lights};
use sunglint::{DistantLight, LightError, SUN};

use crate::chip::PIXEL;
use crate::failure::Failure;
use crate::kernel::Kernel;
use crate::number;

/// What is measured: all of it where nothing is named.
#[derive(Args, Clone, Debug)]
pub struct Filter {
    /// Measure only this method; may be given several times
    ///
    /// The name of a direction method, a highlight method, a building block or a light quantity, as `sunglint list`
    /// prints it, in upper or lower case.
    #[arg(long, value_name = "NAME", ignore_case = true, value_parser = named(methods()), hide_possible_values = true)]
    pub method: Vec<&'static str>,

    /// Measure only in this number format; may be given several times
    #[arg(long, value_name = "NAME", ignore_case = true, value_parser = format_name())]
    pub format: Vec<Format>,

    /// Measure only under lights whose name holds NAME, such as `mars` or `lamp`
    ///
    /// Building blocks and light quantities have no light, and are measured all the same.
    #[arg(long, value_name = "NAME", conflicts_with_all = ["ratio", "angle"])]
    pub light: Option<String>,

    /// A light of your own in place of the study's: radius over distance, 0 to 1
    ///
    /// Lit pixels and highlights need 1e-6 or more.
    #[arg(long, value_name = "X", value_parser = by_ratio, allow_negative_numbers = true, conflicts_with = "angle")]
    pub ratio: Option<Light>,

    /// The same by its diameter in the sky in degrees, 0 to 360 (UsdLux angle)
    ///
    /// Lit pixels and highlights take 1.15e-4 to 180.
    #[arg(long, value_name = "DEG", value_parser = by_angle, allow_negative_numbers = true)]
    pub angle: Option<Light>,

    /// A roughness of your own in place of the study's: GGX width, 0 or 5e-4 to 1
    ///
    /// Lit pixels have it under the Sun, or under the light of --ratio or --angle.
    #[arg(long, value_name = "A", value_parser = width, allow_negative_numbers = true)]
    pub alpha: Option<f64>,
}

/// Roughnesses under a light of the user's: those of the study under the Sun.
const ALPHAS: [f64; 3] = [CASES[0].alpha, CASES[1].alpha, CASES[2].alpha];

impl Filter {
    /// The user's own light.
    pub fn own(&self) -> Option<Light> {
        self.ratio.or(self.angle)
    }

    /// The lights of directions.
    pub fn lights(&self) -> Vec<Light> {
        let study = || lights::STUDY.into_iter().filter(|light| self.wants(light.name)).collect();
        self.own().map_or_else(study, |own| vec![own])
    }

    /// Lights and roughnesses of lit pixels.
    pub fn cases(&self) -> Vec<Case> {
        if self.own().is_none() && self.alpha.is_none() {
            return CASES.into_iter().filter(|case| self.wants(case.name)).collect();
        }
        let light = self.own().unwrap_or(Light { name: "Sun", light: SUN });
        let alphas = self.alpha.map_or(ALPHAS.to_vec(), |alpha| vec![alpha]);
        let cases = alphas.into_iter().map(|alpha| case(light, alpha));
        cases.filter(|case| has_pixels(&case.light) && self.wants(case.name)).collect()
    }

    /// Whether the method of this name is to be measured.
    pub fn wants_method(&self, method: &str) -> bool {
        self.method.is_empty() || self.method.contains(&method)
    }

    /// Whether `format` is to be measured.
    pub fn wants_format(&self, format: Format) -> bool {
        self.format.is_empty() || self.format.contains(&format)
    }

    /// Whether a line of counts is of what is to be measured.
    pub fn wants_count(&self, count: &chip::Row) -> bool {
        let format = Format::named(count.format);
        let format = format.map_or(self.format.is_empty(), |format| self.wants_format(format));
        format && self.wants_method(count.function.strip_prefix(PIXEL).unwrap_or(count.function))
    }

    /// Whether what has this light's or case's name is to be measured.
    pub fn wants(&self, light: &str) -> bool {
        if let Some(own) = self.own() {
            return light.strip_prefix(own.name).is_some_and(|rest| rest.is_empty() || rest.starts_with(", "));
        }
        let holds = |name: &String| light.to_lowercase().contains(&name.to_lowercase());
        self.light.as_ref().is_none_or(holds)
    }

    /// Refuses what no single argument shows to be wrong; `names` are those of all lights.
    pub fn check(&self, names: &[&str]) -> Result<(), Failure> {
        if let (Some(light), None) = (&self.light, names.iter().find(|name| self.wants(name))) {
            return Err(Failure::Usage(format!("no light is named '{light}'; there are: {}", names.join("; "))));
        }
        match (self.own(), self.alpha) {
            (Some(own), Some(_)) if !has_pixels(&own.light) => Err(without_pixels(own)),
            _ => Ok(()),
        }
    }

    /// The arguments that ask for the same.
    pub fn arguments(&self) -> String {
        let methods = self.method.iter().map(|name| format!(" --method {}", quoted(name)));
        let formats = self.format.iter().map(|format| format!(" --format {}", format.name()));
        let light = self.light.iter().map(|name| format!(" --light {}", quoted(name)));
        let own = self.own().into_iter().map(|own| format!(" --{}", own.name));
        let alpha = self.alpha.into_iter().map(|alpha| format!(" --alpha {}", number::shortest(alpha)));
        methods.chain(formats).chain(light).chain(own).chain(alpha).collect()
    }
}

/// That `light` lights no pixels.
pub fn without_pixels(light: Light) -> Failure {
    let range = format!("allowed is a ratio of {LEAST_RATIO:e} to 1, which is an angle of 1.15e-4 to 180 degrees");
    Failure::Usage(format!("{} cannot light a roughness: for lit pixels and highlights {range}", light.name))
}

/// `name` as a shell takes it for one word.
pub fn quoted(name: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "_-./:".contains(c);
    if !name.is_empty() && name.chars().all(plain) {
        name.to_owned()
    } else {
        format!("'{}'", name.replace('\'', r"'\''"))
    }
}

/// A surface of a roughness under `light`.
pub fn case(light: Light, alpha: f64) -> Case {
    Case { name: kept(format!("{}, alpha {}", light.name, number::shortest(alpha))), light: light.light, alpha }
}

/// The least radius over distance that the integrals over a disc are summed for.
const LEAST_RATIO: f64 = 1e-6;

/// Whether there is a truth of what it lights: it looks as a sphere does, at most half the sky, and is no point.
pub fn has_pixels(light: &DistantLight) -> bool {
    light.cos() >= 0.0 && light.sin() >= LEAST_RATIO
}

/// Names of all methods, building blocks and quantities.
pub fn methods() -> Vec<&'static str> {
    let kernels = Kernel::ALL.into_iter().map(Kernel::name);
    shaders().into_iter().chain(kernels).chain(Quantity::ALL.into_iter().map(Quantity::name)).collect()
}

/// Names of direction and highlight methods.
pub fn shaders() -> Vec<&'static str> {
    Method::ALL.into_iter().map(Method::name).chain(Shading::ALL.into_iter().map(Shading::name)).collect()
}

/// Takes one of `names`, in any case.
pub fn named(names: Vec<&'static str>) -> impl TypedValueParser<Value = &'static str> {
    PossibleValuesParser::new(names.clone()).map(move |typed| {
        let same = |name: &&&str| name.eq_ignore_ascii_case(&typed);
        names.iter().find(same).copied().unwrap_or_default()
    })
}

/// Takes the name of a format, in any case.
pub fn format_name() -> impl TypedValueParser<Value = Format> {
    named(Format::ALL.map(Format::name).into()).map(|name| Format::named(name).unwrap_or(Format::F64))
}

/// Takes a light by its radius over distance.
pub fn by_ratio(typed: &str) -> Result<Light, String> {
    let ratio = parsed(typed)?;
    own_light("ratio", ratio, DistantLight::from_ratio(ratio))
}

/// Takes a light by its diameter in degrees.
pub fn by_angle(typed: &str) -> Result<Light, String> {
    let angle = parsed(typed)?;
    own_light("angle", angle, DistantLight::from_angle(angle))
}

fn own_light(kind: &str, value: f64, light: Result<DistantLight, LightError>) -> Result<Light, String> {
    let light = light.map_err(|error| error.to_string())?;
    Ok(Light { name: kept(format!("{kind} {}", number::shortest(value))), light })
}

/// Takes a GGX width.
pub fn width(typed: &str) -> Result<f64, String> {
    let alpha = parsed(typed)?;
    let material = Material::new([0.0; 3], alpha, [0.0; 3]);
    material.map(|_| alpha).map_err(|error: MaterialError| error.to_string())
}

fn parsed(typed: &str) -> Result<f64, String> {
    typed.parse().map_err(|_| "not a number".to_owned())
}

/// `name` for as long as the process runs, as lights and cases have theirs. The same name is kept but once.
fn kept(name: String) -> &'static str {
    static NAMES: Mutex<BTreeSet<&'static str>> = Mutex::new(BTreeSet::new());
    let mut names = NAMES.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = names.get(name.as_str()) {
        return known;
    }
    let name: &'static str = name.leak();
    names.insert(name);
    name
}

#[cfg(test)]
mod tests {
    use crate::failure::Failure;
    use crate::options::{Cli, Options};
    use clap::Parser;
    use sunglint::trial::Format;

    fn refused(arguments: &[&str]) -> String {
        let arguments = ["sunglint"].iter().chain(arguments);
        Cli::try_parse_from(arguments).expect_err("a wrong command line").to_string()
    }

    #[test]
    fn a_light_is_found_by_part_of_its_name_in_any_case() {
        let options = Options::parse_from(["sunglint", "--light", "MARS"]);
        assert!(options.wants("Sun from Mars"));
        assert!(!options.wants("Sun from Earth"));
        assert!(Options::parse_from(["sunglint"]).wants("area light 0.5"));
    }

    #[test]
    fn names_are_taken_in_any_case_and_given_as_tables_have_them() {
        let arguments = ["sunglint", "--method", "CAP", "--method", "cone::DIRECTION", "--format", "i2f14"];
        let options = Options::parse_from(arguments);
        assert!(options.wants_method("cap") && options.wants_method("Cone::direction"));
        assert!(!options.wants_method("disc"));
        assert!(options.wants_format(Format::I2F14) && !options.wants_format(Format::F32));
        assert_eq!(options.command(), "sunglint --method cap --method Cone::direction --format I2F14");
    }

    #[test]
    fn unknown_names_are_refused_with_what_there_is() {
        let message = refused(&["--method", "cup"]);
        assert!(message.contains("'cup'") && message.contains("disc_ggx dir") && message.contains("normalize"));
        let message = refused(&["--format", "f8"]);
        assert!(message.contains("'f8'") && message.contains("I16F16"), "{message}");
        let options = Options::parse_from(["sunglint", "--light", "venus"]);
        let Err(Failure::Usage(message)) = options.check() else { panic!("there is no such light") };
        assert!(message.contains("'venus'") && message.contains("Sun from Mars"), "{message}");
    }

    #[test]
    fn values_out_of_range_are_named_with_the_range() {
        for (arguments, said) in [
            (["--ratio", "1.5"], "radius over distance is 1.5, allowed is 0 to 1"),
            (["--ratio", "-1"], "radius over distance is -1, allowed is 0 to 1"),
            (["--ratio", "nan"], "radius over distance is NaN, allowed is 0 to 1"),
            (["--angle", "400"], "angle is 400 degrees, allowed is 0 to 360"),
            (["--alpha", "1e-4"], "alpha is 0.0001, allowed is 0 or 0.0005 to 1"),
            (["--alpha", "rough"], "not a number"),
        ] {
            let message = refused(&arguments);
            assert!(message.contains(said), "{message}");
        }
        assert!(refused(&["--ratio", "0.1", "--angle", "1"]).contains("cannot be used with"));
        assert!(refused(&["--ratio", "0.1", "--light", "Sun"]).contains("cannot be used with"));
        let options = Options::parse_from(["sunglint", "--angle", "200", "--alpha", "0.1"]);
        let Err(Failure::Usage(message)) = options.check() else { panic!("a light of more than half the sky") };
        assert!(message.contains("200") && message.contains("180"), "{message}");
    }

    #[test]
    fn a_light_of_one_s_own_takes_the_place_of_the_study_s() {
        let options = Options::parse_from(["sunglint", "--ratio", "0.01"]);
        let lights = options.lights();
        assert_eq!((lights.len(), lights[0].name, lights[0].light.sin()), (1, "ratio 0.01", 0.01));
        assert!(!options.wants("Sun from Earth") && !options.wants("ratio 0.015"));
        let names: Vec<_> = options.cases().iter().map(|case| case.name).collect();
        assert_eq!(names, ["ratio 0.01, alpha 0.001", "ratio 0.01, alpha 0.0625", "ratio 0.01, alpha 1"]);
        assert_eq!(Options::parse_from(["sunglint", "--ratio", "1e-300"]).lights()[0].name, "ratio 1e-300");
        let wide = Options::parse_from(["sunglint", "--angle", "200"]);
        assert!(wide.cases().is_empty() && wide.lights().len() == 1);
    }

    #[test]
    fn a_roughness_alone_is_under_the_sun() {
        let options = Options::parse_from(["sunglint", "--alpha", "0.001"]);
        assert_eq!(options.cases(), [sunglint::trial::gloss::CASES[0]]);
        let both = Options::parse_from(["sunglint", "--alpha", "0.3", "--angle", "0.53", "--seed", "7", "--quick"]);
        assert_eq!(both.cases()[0].name, "angle 0.53, alpha 0.3");
        assert_eq!(both.command(), "sunglint --quick --angle 0.53 --alpha 0.3 --seed 7");
    }

    #[test]
    fn names_with_spaces_are_quoted() {
        let options = Options::parse_from(["sunglint", "--method", "disc_ggx dir", "--light", "earth's"]);
        assert_eq!(options.command(), r"sunglint --method 'disc_ggx dir' --light 'earth'\''s'");
    }
}
