//! What every public type of the core can do: be printed, logged, copied, compared and sent to another thread; and what
//! every error can. The sources say which types there are, so that none is left out.

mod public_functions;

use std::any::type_name;
use std::collections::BTreeSet;
use std::error::Error;
use std::fmt::{Debug, Display};
use std::fs;
use std::path::Path;

use public_functions::sources;
use sunglint::highlight::{ConeGgx, DiscGgx, Gloss, PointGgx, ShiftedConeGgx};
use sunglint::light::{Description, DistantLight, LightError};
use sunglint::material::{Material, MaterialError, Surface};
use sunglint::radiometry::{Patch, RadiometryError, SphereLight};
use sunglint::raw::{PixelQ14, SurfaceQ14};
use sunglint::real::{Constant, Halfway, Scaled};
use sunglint::sampling::Cone;
use sunglint::scene::{Channel, Lamp, Scene, SceneError};
use sunglint::sphere::{DistantSphere, UnfactoredSphere};
use sunglint::{capi, fixed::types::I2F14, half::f16, plain, shadow};

/// What neither firmware nor a game has; and the README's examples, which are there for rustdoc alone.
const LEFT_OUT: [&str; 4] = ["oracle::", "trial::", "bin::", "Readme"];

/// A type's path, without its parameters and its crate's name.
fn path<T: ?Sized>() -> String {
    let name = type_name::<T>().split('<').next().unwrap();
    name.strip_prefix("sunglint::").unwrap().to_owned()
}

fn value<T: Debug + Copy + PartialEq + defmt::Format + Send + Sync + Unpin + 'static>() -> String {
    path::<T>()
}

fn error<E: Error + Display + Copy + PartialEq + defmt::Format + Send + Sync + 'static>() -> String {
    path::<E>()
}

/// A list of lights, which is cloned by name only, and holds a function, which no logger can print.
fn scene<T: Debug + Clone + Send + Sync + Unpin + 'static>() -> String {
    path::<T>()
}

fn types() -> BTreeSet<String> {
    let all = [
        [value::<DistantLight>(), value::<Description>(), value::<DistantSphere<f32>>()],
        [value::<DistantSphere<I2F14>>(), value::<UnfactoredSphere<f32>>(), value::<Material>()],
        [value::<Surface<f32>>(), value::<SurfaceQ14>(), value::<Channel>()],
        [value::<Lamp<f32>>(), scene::<Scene<f32, 1>>(), scene::<Scene<f16, 1>>()],
        [value::<Gloss<Scaled>>(), value::<PointGgx<I2F14>>(), value::<DiscGgx<I2F14>>()],
        [value::<ConeGgx<I2F14>>(), value::<ShiftedConeGgx<I2F14>>(), value::<Cone<f32>>()],
        [value::<shadow::SoftShadow<I2F14>>(), value::<Patch<Scaled>>(), value::<SphereLight<Scaled>>()],
        [value::<PixelQ14>(), value::<Scaled>(), value::<Constant>()],
        [value::<Halfway<Scaled>>(), value::<plain::VectorQ14>(), value::<plain::VectorQ30>()],
        [value::<plain::VectorF32>(), value::<plain::ColourQ16>(), value::<plain::ColourQ30>()],
        [value::<plain::MaterialQ30>(), value::<plain::PointQ14>(), value::<plain::PointQ30>()],
        [value::<plain::BasisQ14>(), value::<plain::BasisQ30>(), value::<plain::SoftShadow>()],
        [value::<plain::SphereQ14>(), value::<plain::SphereQ30>(), value::<capi::Status>()],
        [value::<capi::SphereQ14Made>(), value::<capi::SphereQ30Made>(), value::<capi::PixelQ14Made>()],
    ];
    all.into_iter().flatten().chain([value::<capi::RadianceQ16Made>()]).chain(errors()).collect()
}

fn errors() -> BTreeSet<String> {
    [
        error::<LightError>(),
        error::<MaterialError>(),
        error::<MaterialError<Scaled>>(),
        error::<SceneError>(),
        error::<SceneError<Scaled>>(),
        error::<RadiometryError<f32>>(),
        error::<RadiometryError<Scaled>>(),
    ]
    .into()
}

/// The path of every public structure and enumeration that a source has.
fn written(root: &Path, file: &Path) -> Vec<String> {
    let inside = file.strip_prefix(root).unwrap().with_extension("");
    let module = inside.to_str().unwrap().replace(std::path::MAIN_SEPARATOR, "::");
    let module = if module == "lib" { String::new() } else { module + "::" };
    let code = fs::read_to_string(file).unwrap();
    code.lines()
        .filter_map(|line| line.strip_prefix("pub struct ").or(line.strip_prefix("pub enum ")))
        .map(|rest| rest.split(|letter: char| !letter.is_alphanumeric()).next().unwrap())
        .map(|name| format!("{module}{name}"))
        .collect()
}

fn public() -> BTreeSet<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let all = sources(&root).into_iter().flat_map(|file| written(&root, &file));
    all.filter(|name| !LEFT_OUT.iter().any(|start| name.starts_with(start))).collect()
}

#[test]
fn every_public_type_is_printed_logged_copied_and_compared() {
    assert_eq!(types(), public());
}

#[test]
fn every_error_is_one() {
    assert_eq!(errors(), public().into_iter().filter(|name| name.ends_with("Error")).collect());
}
