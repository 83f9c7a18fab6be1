//! One input again: what a method makes of raw bits, the truth, and the error.

mod direction;
mod lanes;
mod pixel;

use clap::Args;
use sunglint::trial::gloss::{CASES, Case};
use sunglint::trial::{Format, Light, Method, Shading, lights};
use sunglint::{DistantLight, SUN};

use crate::failure::Failure;
use crate::filter::{self, quoted};
use crate::options::Options;
use crate::print;
use direction::Direction;
use pixel::LitPixel;

/// `sunglint repro`.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    /// Direction or highlight method, such as `cap` or `cone_ggx`
    #[arg(ignore_case = true, value_parser = filter::named(filter::shaders()), hide_possible_values = true)]
    pub method: &'static str,

    /// Number format
    #[arg(ignore_case = true, value_parser = filter::format_name())]
    pub format: Format,

    /// Full name of the light, or for a lit pixel of the case, as `sunglint list` prints it
    ///
    /// Such as `Sun from Mars`, or `Sun, alpha 0.001`; a direction without a light is under the Sun from Earth.
    #[arg(long, value_name = "NAME", conflicts_with_all = ["ratio", "angle", "alpha"])]
    pub light: Option<String>,

    /// A light of your own: radius over distance, 0 to 1
    #[arg(long, value_name = "X", value_parser = filter::by_ratio, allow_negative_numbers = true, conflicts_with = "angle")]
    pub ratio: Option<Light>,

    /// A light of your own by its diameter in the sky in degrees, 0 to 360
    #[arg(long, value_name = "DEG", value_parser = filter::by_angle, allow_negative_numbers = true)]
    pub angle: Option<Light>,

    /// Roughness of a lit pixel: GGX width, 0 or 5e-4 to 1
    ///
    /// Under the Sun, where no other light is given.
    #[arg(long, value_name = "A", value_parser = filter::width, allow_negative_numbers = true)]
    pub alpha: Option<f64>,

    /// Direction to the light: raw bits of x, y and z in hexadecimal, such as '0 0 3c00'
    #[arg(long, value_name = "BITS")]
    pub l: String,

    /// Mirror direction, for direction methods
    #[arg(long, value_name = "BITS")]
    pub r: Option<String>,

    /// Normal, for lit pixels
    #[arg(long, value_name = "BITS")]
    pub n: Option<String>,

    /// Direction to the viewer, for lit pixels
    #[arg(long, value_name = "BITS")]
    pub v: Option<String>,
}

/// What is to be computed.
enum Subject {
    /// A direction.
    Direction(Direction),
    /// A lit pixel.
    Pixel(LitPixel),
}

/// The command.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    print(&match arguments.subject()? {
        Subject::Direction(direction) => direction.text(),
        Subject::Pixel(pixel) => pixel.text(),
    });
    Ok(())
}

impl Arguments {
    fn subject(&self) -> Result<Subject, Failure> {
        let Self { method, format, .. } = *self;
        if let Some(method) = Method::named(method) {
            self.takes(
                ["--r"],
                [&self.r],
                ["--n", "--v", "--alpha"],
                [self.n.is_some(), self.v.is_some(), self.alpha.is_some()],
            )?;
            let [l, r] = [self.lanes("--l", Some(&self.l))?, self.lanes("--r", self.r.as_deref())?];
            return Ok(Subject::Direction(Direction { method, format, light: self.light()?, l, r }));
        }
        let method = Shading::named(method).unwrap_or(Shading::None);
        self.takes(["--n", "--v"], [&self.n, &self.v], ["--r"], [self.r.is_some()])?;
        let [n, v] = [self.lanes("--n", self.n.as_deref())?, self.lanes("--v", self.v.as_deref())?];
        let l = self.lanes("--l", Some(&self.l))?;
        Ok(Subject::Pixel(LitPixel { method, format, case: self.case()?, n, v, l }))
    }

    /// Refuses vectors that are missing, and what the method has no use for.
    fn takes<const A: usize, const B: usize>(
        &self,
        needed: [&str; A],
        given: [&Option<String>; A],
        useless: [&str; B],
        present: [bool; B],
    ) -> Result<(), Failure> {
        let of = self.method;
        if let Some((name, _)) = needed.into_iter().zip(given).find(|(_, bits)| bits.is_none()) {
            return Err(Failure::Usage(format!("{of} needs --l, {}; {name} is missing", needed.join(", "))));
        }
        match useless.into_iter().zip(present).find(|(_, present)| *present) {
            Some((name, _)) => Err(Failure::Usage(format!("{of} takes --l, {}; not {name}", needed.join(", ")))),
            None => Ok(()),
        }
    }

    fn lanes(&self, name: &str, bits: Option<&str>) -> Result<[f64; 3], Failure> {
        lanes::read(name, bits.unwrap_or_default(), self.format)
    }

    /// The light of a direction.
    fn light(&self) -> Result<Light, Failure> {
        if let Some(own) = self.ratio.or(self.angle) {
            return Ok(own);
        }
        let Some(name) = &self.light else { return Ok(lights::STUDY[0]) };
        let known = lights::STUDY.into_iter().find(|light| light.name.eq_ignore_ascii_case(name));
        known.ok_or_else(|| unknown("light", name, &lights::STUDY.map(|light| light.name)))
    }

    /// Light and roughness of a lit pixel.
    fn case(&self) -> Result<Case, Failure> {
        if let Some(name) = &self.light {
            let known = CASES.into_iter().find(|case| case.name.eq_ignore_ascii_case(name));
            return known.ok_or_else(|| unknown("case of lit pixels", name, &CASES.map(|case| case.name)));
        }
        let light = self.ratio.or(self.angle).unwrap_or(Light { name: "Sun", light: SUN });
        let Some(alpha) = self.alpha else {
            let message = format!("{} needs a roughness: --alpha, or --light with the name of a case", self.method);
            return Err(Failure::Usage(message));
        };
        if filter::has_pixels(&light.light) {
            Ok(filter::case(light, alpha))
        } else {
            Err(filter::without_pixels(light))
        }
    }
}

fn unknown(what: &str, name: &str, names: &[&str]) -> Failure {
    Failure::Usage(format!("no {what} is named '{name}'; there are: {}", names.join("; ")))
}

/// What a light is, in numbers.
fn measures(light: &DistantLight) -> String {
    format!("radius over distance {}, angular radius {} rad", light.sin(), light.angular_radius())
}

/// An angle in units of the light's radius, which a point has none of.
fn in_radii(angle: f64, light: &DistantLight) -> String {
    let radii = angle / light.angular_radius();
    match radii {
        radii if !radii.is_finite() || radii == 0.0 => String::new(),
        radii if radii < 0.01 => format!(", {radii:.3e} radii of the light"),
        radii => format!(", {radii:.4} radii of the light"),
    }
}

/// What of a budget an error uses up.
fn used(error: f64, budget: Option<f64>, unit: &str) -> String {
    match budget {
        // The answer is no number, or no direction.
        Some(budget) if !error.is_finite() => format!("budget            {budget:e}{unit}, broken"),
        Some(budget) => format!("budget            {budget:e}{unit}, of which this is {:.1} %", error / budget * 100.0),
        None => "budget            none: the study promises nothing here".to_owned(),
    }
}

/// The command that computes a direction again; `l` and `r` are raw bits as in `Row::worst_l`.
pub fn of_direction(light: &str, method: &str, format: &str, [l, r]: [&str; 2]) -> String {
    format!("sunglint repro {method} {format} {} --l '{l}' --r '{r}'", asked(light))
}

/// The command that computes a lit pixel again; the vectors are raw bits as in `PixelRow::worst_n`.
pub fn of_pixel(case: &str, method: &str, format: &str, [n, v, l]: [&str; 3]) -> String {
    let light = match case.split_once(", alpha ") {
        Some(("Sun", alpha)) if !is_known(case) => format!("--alpha {alpha}"),
        Some((light, alpha)) if !is_known(case) => format!("{} --alpha {alpha}", asked(light)),
        _ => asked(case),
    };
    format!("sunglint repro {} {format} {light} --n '{n}' --v '{v}' --l '{l}'", quoted(method))
}

/// The command that finds the worst input of a building block again, over as many inputs.
pub fn of_kernel(kernel: &str, format: &str, options: &Options) -> String {
    let quick = if options.quick { " --quick" } else { "" };
    format!("sunglint worst{quick} --method {} --format {format}{}", quoted(kernel), options.seeded())
}

fn is_known(case: &str) -> bool {
    CASES.iter().any(|known| known.name == case)
}

/// The argument for a light: by its name, which stands for all of its bits, or the number that the user gave.
fn asked(light: &str) -> String {
    match light.split_once(' ') {
        Some((kind @ ("ratio" | "angle"), value)) => format!("--{kind} {value}"),
        _ => format!("--light {}", quoted(light)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::options::{Cli, Command};
    use crate::{directions, kernels, number, pixels, worst};
    use clap::Parser;
    use indicatif::ProgressBar;

    /// A command line as a shell splits it.
    fn words(command: &str) -> Vec<String> {
        let parts = command.split('\'').enumerate();
        let words = parts.flat_map(|(place, part)| match place % 2 {
            0 => part.split_whitespace().map(str::to_owned).collect(),
            _ => vec![part.to_owned()],
        });
        words.collect()
    }

    fn subject(command: &str) -> Subject {
        let cli = Cli::try_parse_from(words(command)).unwrap_or_else(|error| panic!("{command}: {error}"));
        let Some(Command::Repro(arguments)) = cli.command else { panic!("{command}") };
        arguments.subject().unwrap_or_else(|failure| panic!("{command}: {failure}"))
    }

    fn message(command: &str) -> String {
        let cli = Cli::try_parse_from(words(command)).unwrap_or_else(|error| panic!("{command}: {error}"));
        let Some(Command::Repro(arguments)) = cli.command else { panic!("{command}") };
        arguments.subject().map(drop).expect_err("a wrong command").to_string()
    }

    /// Two studies: that of all lights, and that of the user's own.
    fn studies() -> [Options; 3] {
        [
            Options::parse_from(["sunglint", "--quick"]),
            Options::parse_from(["sunglint", "--quick", "--ratio", "0.123456789012345"]),
            Options::parse_from(["sunglint", "--quick", "--alpha", "0.31", "--angle", "0.53"]),
        ]
    }

    #[test]
    fn the_command_of_a_direction_gives_its_error_to_the_last_digit() {
        for options in studies() {
            let rows = directions::errors(&options, &ProgressBar::hidden());
            assert_eq!(rows.len(), directions::rows(&options));
            for row in rows {
                let command = of_direction(&row.light, &row.method, &row.format, [&row.worst_l, &row.worst_r]);
                let Subject::Direction(direction) = subject(&command) else { panic!("{command}") };
                let computed = direction.computed();
                assert_eq!(computed.error.to_bits(), row.error_max.to_bits(), "{command}");
                assert!(direction.text().contains(&number::shortest(row.error_max)), "{}", direction.text());
            }
        }
    }

    #[test]
    fn the_command_of_a_pixel_gives_its_error_to_the_last_digit() {
        for options in studies() {
            let rows = pixels::errors(&pixels::Truths::default(), &options, &ProgressBar::hidden());
            assert_eq!(rows.len(), pixels::rows(&options));
            for row in rows {
                let vectors = [row.worst_n.as_str(), &row.worst_v, &row.worst_l];
                let command = of_pixel(&row.case, &row.method, &row.format, vectors);
                let Subject::Pixel(pixel) = subject(&command) else { panic!("{command}") };
                assert_eq!(pixel.computed().error.to_bits(), row.error_max.to_bits(), "{command}");
            }
        }
    }

    #[test]
    fn the_command_of_a_building_block_gives_its_error_again() {
        let options = Options::parse_from(["sunglint", "--quick", "--seed", "5", "--method", "tint"]);
        for row in kernels::errors(&options, &ProgressBar::hidden()) {
            let command = of_kernel(&row.kernel, &row.format, &options);
            let Some(Command::Worst(arguments)) = Cli::parse_from(words(&command)).command else { panic!("{command}") };
            let found = worst::rows(&arguments.options, &ProgressBar::hidden());
            assert_eq!(found.len(), 1, "{command}");
            assert_eq!(found[0].error.to_bits(), row.error_max.to_bits(), "{command}");
        }
    }

    #[test]
    fn lights_are_the_same_bits() {
        let light = |asked: &str| match subject(&format!("sunglint repro cap f16 {asked} --l '0 0 1' --r '0 0 1'")) {
            Subject::Direction(direction) => direction.light,
            Subject::Pixel(_) => panic!("{asked}"),
        };
        for known in lights::STUDY {
            assert_eq!(light(&asked(known.name)), known);
        }
        assert_eq!(light("--light 'sun FROM mars'"), lights::STUDY[1]);
        assert_eq!(light(""), lights::STUDY[0]);
    }

    #[test]
    fn wrong_vectors_are_told_with_what_is_allowed() {
        for (command, said) in [
            ("cap f16 --l '0 0 3c00' --r '0 0'", "--r has 2 numbers, allowed is 3"),
            ("cap f16 --l '0 0 13c00' --r '0 0 0'", "13c00 in --l is no number of f16, allowed is 0 to ffff"),
            ("cap f16 --l '0 0 x' --r '0 0 0'", "'x' in --l is no number in hexadecimal, allowed is 0 to ffff"),
            ("cap f16 --l '0 0 0'", "--r is missing"),
            ("cap f16 --l '0 0 0' --r '0 0 0' --n '0 0 0'", "not --n"),
            ("karis f16 --l '0 0 0' --n '0 0 0' --alpha 0.1", "--v is missing"),
            ("karis f16 --l '0 0 0' --n '0 0 0' --v '0 0 0'", "needs a roughness"),
            ("karis f16 --l '0 0 0' --n '0 0 0' --v '0 0 0' --alpha 0.1 --angle 181", "180"),
            ("karis f16 --l '0 0 0' --n '0 0 0' --v '0 0 0' --light Moon", "'Moon'"),
            ("cap f16 --l '0 0 0' --r '0 0 0' --light Moon", "Sun from Jupiter"),
        ] {
            let message = message(&format!("sunglint repro {command}"));
            assert!(message.contains(said), "{message}");
        }
    }

    #[test]
    fn nonsense_is_computed_without_a_panic() {
        for method in filter::shaders() {
            for format in Format::ALL {
                let most = "f".repeat(format.width() / 4);
                let name = format.name();
                for bits in ["0 0 0", &format!("{most},0x{most} 1"), "1 0 0"] {
                    let vectors = match Method::ALL.iter().any(|known| known.name() == method) {
                        true => format!("--r '{bits}'"),
                        false => format!("--n '{bits}' --v '{bits}' --alpha 0"),
                    };
                    for light in ["", "--ratio 1e-6", "--ratio 1"] {
                        match subject(&format!("sunglint repro '{method}' {name} {light} --l '{bits}' {vectors}")) {
                            Subject::Direction(direction) => assert!(!direction.text().is_empty()),
                            Subject::Pixel(pixel) => assert!(!pixel.text().is_empty()),
                        }
                    }
                }
            }
        }
    }
}
