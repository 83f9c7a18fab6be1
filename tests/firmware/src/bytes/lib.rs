//! Functions to link one by one, so that the linked file has their bytes, those of all that they call, and no others.
//! The name of each is that of its row: function, format and author. `sizes` in `run` links them.
#![no_std]

#[path = "../calls/mod.rs"]
mod calls;

use peers::kernels::{cordic as cordic_peers, f32 as f32_peers, fixed as fixed_peers, idsp as idsp_peers};
use sunglint::Real;
use sunglint::fixed::types::{I2F14, I2F30, I3F29, I16F16, U16F16};
use sunglint::half::f16;
use sunglint::highlight::{ConeGgx, DiscGgx, Gloss, PointGgx, ShiftedConeGgx};
use sunglint::micromath::F32;
use sunglint::raw::{self, SphereQ14};

use calls::by_hand::{self, Seen, SoftRay};
use calls::directions::{self, Ray};
use calls::highlights::{self, Glossy, Lit};
use calls::sampling::{self, Facing, Matt, Sample};
use calls::vectors;

/// Exports a function under the name of a row.
macro_rules! export {
    ($name:expr, $call:path, $input:ty, $output:ty) => {
        const _: () = {
            #[unsafe(export_name = $name)]
            fn call(input: &$input) -> $output {
                $call(input)
            }
        };
    };
}

/// Exports the functions of all formats for the format `T`.
macro_rules! format {
    ($format:ty, $name:literal) => {
        const _: () = {
            type T = $format;
            type S = <T as Real>::Scalar;
            type W = <T as Real>::Wide;
            type L = <T as Real>::Level;
            export!(concat!("epic/", $name, "/sunglint"), directions::epic, Ray<T>, [T; 3]);
            export!(concat!("factored/", $name, "/sunglint"), directions::factored, Ray<T>, [T; 3]);
            export!(concat!("disc/", $name, "/sunglint"), directions::disc, Ray<T>, [T; 3]);
            export!(concat!("cap/", $name, "/sunglint"), directions::cap, Ray<T>, [T; 3]);
            export!(concat!("dot/", $name, "/sunglint"), vectors::dot, [[T; 3]; 2], W);
            export!(concat!("reflect/", $name, "/sunglint"), vectors::reflect, [[T; 3]; 2], [T; 3]);
            export!(concat!("normalize/", $name, "/sunglint"), vectors::normalize, [T; 3], [T; 3]);
            export!(concat!("root/", $name, "/sunglint"), vectors::root, S, S);
            export!(concat!("basis/", $name, "/sunglint"), sampling::basis, [T; 3], [[T; 3]; 2]);
            export!(concat!("sin_cos/", $name, "/sunglint"), sampling::sin_cos, S, [S; 2]);
            export!(concat!("Cone::direction/", $name, "/sunglint"), sampling::cone_direction, Sample<T>, [T; 3]);
            export!(concat!("relative_illuminance/", $name, "/sunglint"), sampling::relative_illuminance, Facing<T>, S);
            export!(concat!("lambert/", $name, "/sunglint"), sampling::lambert, Matt<T>, L);
            type Point = Glossy<T, PointGgx<T>>;
            type Disc = Glossy<T, DiscGgx<T>>;
            export!(concat!("none/", $name, "/sunglint"), highlights::shade, Point, Gloss<S>);
            export!(concat!("karis/", $name, "/sunglint"), highlights::shade, Point, Gloss<S>);
            export!(concat!("karis/3/", $name, "/sunglint"), highlights::shade, Point, Gloss<S>);
            export!(concat!("exact_rp/", $name, "/sunglint"), highlights::shade, Point, Gloss<S>);
            export!(concat!("disc_ggx/", $name, "/sunglint"), highlights::shade, Disc, Gloss<S>);
            export!(concat!("disc_ggx dir/", $name, "/sunglint"), highlights::shade, Disc, Gloss<S>);
    export!(concat!("cone_ggx/", $name, "/sunglint"), highlights::shade, Glossy<T, ConeGgx<T>>, Gloss<S>);
            type Shifted = Glossy<T, ShiftedConeGgx<T>>;
            export!(concat!("cone_ggx shifted/", $name, "/sunglint"), highlights::shade, Shifted, Gloss<S>);
    export!(concat!("pixel karis/", $name, "/sunglint"), highlights::pixel, Lit<T, PointGgx<T>>, L);
    export!(concat!("pixel disc_ggx/", $name, "/sunglint"), highlights::pixel, Lit<T, DiscGgx<T>>, L);
    export!(concat!("pixel disc_ggx dir/", $name, "/sunglint"), highlights::pixel, Lit<T, DiscGgx<T>>, L);
    export!(concat!("pixel cone_ggx/", $name, "/sunglint"), highlights::pixel, Lit<T, ConeGgx<T>>, L);
        };
    };
}

format!(f64, "f64");
format!(f32, "f32");
format!(F32, "micromath");
format!(f16, "f16");
format!(I2F14, "I2F14");
format!(I2F30, "I2F30");
format!(I16F16, "I16F16");

export!("reciprocal root/f64/sunglint", vectors::reciprocal_root, f64, f64);
export!("reciprocal root/f32/sunglint", vectors::reciprocal_root, f32, f32);
export!("reciprocal root/micromath/sunglint", vectors::reciprocal_root, F32, F32);
export!("reciprocal root/f16/sunglint", vectors::reciprocal_root, f16, f16);
export!("reciprocal root/Q31/sunglint", vectors::mantissa_reciprocal_root, u32, u32);
export!("cap/f32/sunglint soft", by_hand::soft_cap, SoftRay, [f32; 3]);
export!("reflect/f32/sunglint soft", by_hand::soft_reflect, [[f32; 3]; 2], [f32; 3]);
export!("normalize/f32/sunglint soft", by_hand::soft_normalize, [f32; 3], [f32; 3]);
export!("root/f32/sunglint soft", by_hand::soft_root, f32, f32);
export!("reciprocal root/f32/sunglint soft", by_hand::soft_reciprocal_root, f32, f32);
export!("reciprocal root/U16F16/sunglint", by_hand::reciprocal_root_q16, u32, u32);
export!("pixel disc_ggx/I2F14/PixelQ14", by_hand::pixel_q14, Seen, u32);
export!("cap/I2F14/formula", directions::cap_by_formula, Ray<I2F14>, [I2F14; 3]);
export!("cap/I2F30/formula", directions::cap_by_formula, Ray<I2F30>, [I2F30; 3]);

/// A direction method and the normalisation together: what an integer-only image has of this crate at the least.
const _: () = {
    #[unsafe(export_name = "flash")]
    fn call(l: [i16; 3], r: [i16; 3], light: &SphereQ14) -> [i16; 3] {
        raw::normalize_q14(raw::cap_q14(l, r, light))
    }
};

/// Exports a peer's functions over f32 by its roots.
macro_rules! peer_f32 {
    ($by:literal, $roots:ty) => {
        export!(concat!("factored/f32/", $by), f32_peers::factored::<$roots>, f32_peers::Ray, [f32; 3]);
        export!(concat!("cap/f32/", $by), f32_peers::cap::<$roots>, f32_peers::Ray, [f32; 3]);
        export!(concat!("normalize/f32/", $by), f32_peers::normalize::<$roots>, [f32; 3], [f32; 3]);
        export!(concat!("root/f32/", $by), f32_peers::root::<$roots>, f32, f32);
        export!(concat!("reciprocal root/f32/", $by), f32_peers::reciprocal_root::<$roots>, f32, f32);
    };
}

peer_f32!("libm 0.2.16", f32_peers::Libm);
peer_f32!("micromath 2.1.0", f32_peers::Micromath);
export!("dot/I2F14/fixed 1.31.0", fixed_peers::dot, [[I2F14; 3]; 2], I2F14);
export!("dot/I2F30/fixed 1.31.0", fixed_peers::dot, [[I2F30; 3]; 2], I2F30);
export!("dot/I16F16/fixed 1.31.0", fixed_peers::dot, [[I16F16; 3]; 2], I16F16);
export!("normalize/I2F14/fixed 1.31.0", fixed_peers::normalize, [I2F14; 3], [I2F14; 3]);
export!("normalize/I2F30/fixed 1.31.0", fixed_peers::normalize, [I2F30; 3], [I2F30; 3]);
export!("normalize/I16F16/fixed 1.31.0", fixed_peers::normalize, [I16F16; 3], [I16F16; 3]);
export!("root/U16F16/fixed 1.31.0", fixed_peers::root, U16F16, U16F16);
export!("reciprocal root/U16F16/fixed 1.31.0", fixed_peers::reciprocal_root, U16F16, U16F16);
export!("root/I16F16/cordic 0.1.5", cordic_peers::root, I16F16, I16F16);
export!("sin_cos/I3F29/cordic 0.1.5", cordic_peers::sin_cos, I3F29, [I3F29; 2]);
export!("sin_cos/Q31/idsp 0.23.1", idsp_peers::sin_cos, i32, [i32; 2]);

#[panic_handler]
fn panicked(_: &core::panic::PanicInfo) -> ! {
    loop {
        core::hint::spin_loop();
    }
}
