//! A lit pixel by `DiscGgx` in I2F30.
#![no_std]
#![no_main]

use minimal::shade;
use sunglint::fixed::types::{I2F30, U32F32};
use sunglint::{DistantSphere, SUN};

const TOWARDS_SUN: [I2F30; 3] = [I2F30::lit("0.6"), I2F30::ZERO, I2F30::lit("0.8")];

static SPHERE: DistantSphere<I2F30> = DistantSphere::<I2F30>::new(&SUN);

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    shade(TOWARDS_SUN, &SPHERE, [U32F32::PI; 3])
}
