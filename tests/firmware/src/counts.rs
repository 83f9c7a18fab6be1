//! Prints what calls cost as CSV.
#![no_std]
#![no_main]

mod counter;

use core::mem::MaybeUninit;
use core::panic::PanicInfo;

use cortex_m_rt::entry;
use cortex_m_semihosting::{debug, hprintln};
use sunglint::fixed::types::{I2F14, I2F30};
use sunglint::highlight::*;
use sunglint::trial::input;
use sunglint::{DistantSphere, Real, SUN, cap, normalize};

struct Pair<T: Real> {
    l: [T; 3],
    r: [T; 3],
    light: &'static DistantSphere<T>,
}

static Q14: DistantSphere<I2F14> = DistantSphere::<I2F14>::new(&SUN);
static Q30: DistantSphere<I2F30> = DistantSphere::<I2F30>::new(&SUN);
static F32: DistantSphere<f32> = DistantSphere::<f32>::new(&SUN);

fn all<T: Real>(light: &'static DistantSphere<T>) {
    for angle in [0.001, 0.004, 0.5, 2.5] {
        let pair = input::scene(angle);
        let pair = Pair { l: pair.l.map(T::from_f64), r: pair.r.map(T::from_f64), light };
        let f: counter::Call<Pair<T>, [T; 3]> = |p| MaybeUninit::new(cap(p.l, p.r, p.light));
        let g: counter::Call<Pair<T>, [T; 3]> = |p| MaybeUninit::new(normalize(p.l));
        let cone = ConeGgx::new(light, <T::Scalar as sunglint::Scalar>::nearest(0.1));
        let disc = DiscGgx::new(light, <T::Scalar as sunglint::Scalar>::nearest(0.1));
        let karis = PointGgx::karis(light, <T::Scalar as sunglint::Scalar>::nearest(0.1));
        let h: counter::Call<(&Pair<T>, ConeGgx<T>), Gloss<T::Scalar>> =
            |p| MaybeUninit::new(p.1.shade(p.0.l, p.0.r, p.0.l));
        let i: counter::Call<(&Pair<T>, DiscGgx<T>), Gloss<T::Scalar>> =
            |p| MaybeUninit::new(p.1.shade(p.0.l, p.0.r, p.0.l));
        let j: counter::Call<(&Pair<T>, PointGgx<T>), Gloss<T::Scalar>> =
            |p| MaybeUninit::new(p.1.shade(p.0.l, p.0.r, p.0.l));
        hprintln!(
            "{} {} cap {} normalize {} cone {} disc {} karis {}",
            T::NAME,
            angle,
            counter::instructions(f, &pair),
            counter::instructions(g, &pair),
            counter::instructions(h, &(&pair, cone)),
            counter::instructions(i, &(&pair, disc)),
            counter::instructions(j, &(&pair, karis))
        );
    }
}

#[entry]
fn main() -> ! {
    counter::start(cortex_m::Peripherals::take().unwrap().SYST);
    let f: counter::Call<u32, u32> = |x| MaybeUninit::new(sunglint::trial::mantissa::reciprocal_root(*x));
    hprintln!("root {}", counter::instructions(f, &0x7234_1234));
    let f: counter::Call<f32, f32> = |x| MaybeUninit::new(<f32 as sunglint::Scalar>::root(*x));
    hprintln!("sqrtf {}", counter::instructions(f, &3.3));
    all::<I2F14>(&Q14);
    all::<I2F30>(&Q30);
    all::<f32>(&F32);
    end(true)
}

#[panic_handler]
fn panicked(info: &PanicInfo) -> ! {
    hprintln!("{}", info);
    end(false)
}

fn end(success: bool) -> ! {
    debug::exit(if success { debug::EXIT_SUCCESS } else { debug::EXIT_FAILURE });
    loop {}
}
