//! What every public type of the core can do: be printed, logged, copied, compared and sent to another thread; and what
//! every error can. Types are found in the sources, so that none is left out.

use std::any::type_name;
use std::collections::BTreeSet;
use std::error::Error;
use std::fmt::Debug;
use std::fs;
use std::path::{Path, PathBuf};

use defmt::Format;
use half::f16;
use sunglint::fixed::types::{I2F14, I2F30, I16F16};
use sunglint::highlight::{ConeGgx, DiscGgx, Gloss, PointGgx, ShiftedConeGgx};
use sunglint::light::{Description, DistantLight, LightError};
use sunglint::material::{Material, MaterialError, Surface};
use sunglint::micromath::F32;
use sunglint::radiometry::{Patch, RadiometryError, SphereLight};
use sunglint::raw::PixelQ14;
use sunglint::real::{Constant, Halfway, Scaled};
use sunglint::sampling::Cone;
use sunglint::scene::{Channel, Lamp, Scene, SceneError};
use sunglint::shadow::SoftShadow;
use sunglint::sphere::{DistantSphere, UnfactoredSphere};
use sunglint::capi;

/// What neither firmware nor a game has.
const STUDY: [&str; 3] = ["src/oracle", "src/trial", "src/bin"];

fn value<T: Debug + Copy + PartialEq + Send + Sync + Unpin + 'static>() -> &'static str {
    type_name::<T>()
}

fn formats<T: Format>() -> &'static str {
    type_name::<T>()
}

fn error<E: Error + Copy + PartialEq + Send + Sync + 'static>() -> &'static str {
    type_name::<E>()
}

fn list() -> i32 {
    0
}

fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        if entry.is_dir() {
            files.extend(sources(&entry));
        } else if entry.extension().is_some_and(|extension| extension == "rs") {
            files.push(entry);
        }
    }
    files
}
