//! A lit pixel by `DiscGgx` in I16F16.
#![no_std]
#![no_main]

use minimal::shade;
use sunglint::fixed::types::{I16F16, U16F16};
use sunglint::{DistantSphere, SUN};

const TOWARDS_SUN: [I16F16; 3] = [I16F16::lit("0.6"), I16F16::ZERO, I16F16::lit("0.8")];

static SPHERE: DistantSphere<I16F16> = DistantSphere::<I16F16>::new(&SUN);

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    shade(TOWARDS_SUN, &SPHERE, [U16F16::PI; 3])
}
