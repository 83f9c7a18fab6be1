//! A lit pixel by `DiscGgx` in I2F14.
#![no_std]
#![no_main]

use minimal::shade;
use sunglint::fixed::types::{I2F14, U16F16};
use sunglint::{DistantSphere, SUN};

const TOWARDS_SUN: [I2F14; 3] = [I2F14::lit("0.6"), I2F14::ZERO, I2F14::lit("0.8")];

static SPHERE: DistantSphere<I2F14> = DistantSphere::<I2F14>::new(&SUN);

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    shade(TOWARDS_SUN, &SPHERE, [U16F16::PI; 3])
}
