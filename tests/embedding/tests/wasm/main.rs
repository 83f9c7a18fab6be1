//! sunglint in WebAssembly, under the interpreter wasmi and under node: the README's module `glint`, whose functions take
//! and give scalars, and the functions of C, which take and give structs in memory. Both give the bits that Rust gives.

mod host;

use std::process::Command;

use embedding::hashes::{CASES, Source, directions_q14};
use embedding::tools;
use sunglint::capi::SphereQ14;
use sunglint::raw::{self, SUN_Q14, SUN_Q30};
use wasmi::{Config, Engine, Error, Module};

use self::host::{
    BUILD_C_LAYER, BUILD_GLINT, C_LAYER, Directions, GLINT, Host, Lanes, ROOT, Scalars, Structs, c_layer, glint, hash,
    packed, path,
};

/// The hash that `wasm/hash.mjs` prints.
fn hash_under_node(module: &str, light: &[i32]) -> u32 {
    let output = Command::new("node")
        .args([concat!(env!("CARGO_MANIFEST_DIR"), "/wasm/hash.mjs"), module])
        .args(light.iter().map(i32::to_string))
        .output()
        .expect("node");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let printed = String::from_utf8(output.stdout).expect("a number");
    u32::from_str_radix(printed.trim(), 16).expect("a number")
}

/// `glint` with one entry of the table of roots, at the end of its data, off by a unit.
fn planted() -> Vec<u8> {
    let mut wasm = glint().to_vec();
    *wasm.last_mut().expect("data") ^= 1;
    wasm
}

#[test]
fn the_same_bits_under_wasmi() {
    assert_eq!(hash(&mut Scalars(Host::new(glint()))), directions_q14());
    assert_eq!(hash(&mut Structs::new(c_layer(), SUN_Q14.into())), directions_q14());
}

#[test]
fn a_planted_difference_is_found_under_wasmi() {
    const POINT: SphereQ14 = SphereQ14 { sin: 0, sin_square: 0, cos: 1 << 28, versine: 0 };
    assert_ne!(hash(&mut Scalars(Host::new(&planted()))), directions_q14());
    assert_ne!(hash(&mut Structs::new(c_layer(), POINT)), directions_q14());
}

#[test]
fn the_same_bits_under_node_and_a_planted_difference_is_found() {
    if !tools::found("node", "apt-get install -y nodejs") {
        return;
    }
    glint();
    c_layer();
    let SphereQ14 { sin, sin_square, cos, versine } = SUN_Q14.into();
    assert_eq!(hash_under_node(&path(GLINT), &[]), directions_q14());
    assert_eq!(hash_under_node(&path(C_LAYER), &[sin, sin_square, cos, versine]), directions_q14());

    let file = path("release/planted.wasm");
    std::fs::write(&file, planted()).expect(&file);
    assert_ne!(hash_under_node(&file, &[]), directions_q14());
    assert_ne!(hash_under_node(&path(C_LAYER), &[0, 0, 1 << 28, 0]), directions_q14());
}

/// A struct with a status in it.
#[test]
fn a_light_is_made_in_the_module() {
    const SUN_RATIO: i32 = 4_994_522;
    let SphereQ14 { sin, sin_square, cos, versine } = raw::sphere_q14(SUN_RATIO).expect("below 1").into();
    let mut structs = Structs::new(c_layer(), SUN_Q14.into());
    let result = structs.at(0);
    structs.host.call::<_, ()>("sunglint_sphere_q14", (result, SUN_RATIO));
    let expected = [0, sin, sin_square, cos, versine].map(i32::to_le_bytes);
    assert_eq!(structs.read::<20>(0), expected.as_flattened());
    structs.host.call::<_, ()>("sunglint_sphere_q14", (result, -1));
    assert_eq!(structs.read::<4>(0), [1, 0, 0, 0], "the status of a ratio that is refused");
}

/// Structs of 64 bits, one that is opaque, one by pointer, and none.
#[test]
fn an_opaque_struct_stays_in_the_module() {
    const L: [i32; 3] = [644_245_094, 0, 858_993_459];
    let mut structs = Structs::new(c_layer(), SUN_Q14.into());
    let sunglint::capi::SphereQ30 { sin, sin_square, cos, versine } = SUN_Q30.into();
    structs.write(1, L.map(i32::to_le_bytes).as_flattened());
    structs.write(2, [sin, sin_square, cos, versine].map(i64::to_le_bytes).as_flattened());
    let [result, l, light, cone, point] = [0, 1, 2, 3, 4].map(|slot| structs.at(slot));
    structs.host.call::<_, ()>("sunglint_cone_q30", (cone, l, light));
    let expected = raw::cone_q30(L, &SUN_Q30);
    for (index, square) in (0..64).zip(raw::points_q30(0, 64)) {
        structs.host.call::<_, ()>("sunglint_point_q30", (point, index));
        structs.host.call::<_, ()>("sunglint_cone_direction_q30", (result, cone, point));
        let direction = raw::cone_direction_q30(&expected, square).map(i32::to_le_bytes);
        assert_eq!(structs.read::<12>(0), direction.as_flattened());
        assert_eq!(structs.host.call::<_, i32>("sunglint_cone_contains_q30", (cone, result)), 1);
    }
    structs.host.call::<_, ()>("sunglint_cone_direction_q30", (result, 0, point));
    assert_eq!(structs.read::<12>(0), [0; 12], "NULL");
}

/// The glint of the README's first example.
#[test]
fn full_on_the_disc_and_nothing_far_from_it() {
    let mut host = Host::new(glint());
    let mut brightness = |l: Lanes| -> i32 {
        let up = packed([0, 0, 16384]);
        host.call("glint_q14", (up, up, packed(l)))
    };
    assert_eq!(brightness([76, 0, 16384]), 255);
    assert_eq!(brightness([8192, 0, 14189]), 0);
    // Half a degree outside.
    assert!((64..192).contains(&brightness([76 + 200, 0, 16382])));
}

/// The module as an interpreter has it that knows WebAssembly 1.0, signs of bytes and halves, and no floats.
fn on_a_plain_interpreter(wasm: &[u8]) -> Result<(Engine, Module), Error> {
    let mut config = Config::default();
    config
        .floats(false)
        .wasm_mutable_global(false)
        .wasm_multi_value(false)
        .wasm_bulk_memory(false)
        .wasm_reference_types(false)
        .wasm_tail_call(false)
        .wasm_extended_const(false)
        .wasm_saturating_float_to_int(false)
        .wasm_multi_memory(false);
    let engine = Engine::new(&config);
    let module = Module::new(&engine, wasm)?;
    Ok((engine, module))
}

#[test]
fn the_module_asks_for_nothing() {
    let (_engine, module) = on_a_plain_interpreter(glint()).expect("no float, nothing beyond 1.0 but signs");
    assert_eq!(module.imports().count(), 0);
    let mut exports: Vec<_> = module.exports().map(|export| export.name().to_owned()).collect();
    exports.sort_unstable();
    let expected = ["__data_end", "__heap_base", "cap_q14", "glint_q14", "memory", "normalize_q14", "reflect_q14"];
    assert_eq!(exports, expected);
    let memory = module.get_export("memory").expect("memory");
    assert_eq!(memory.memory().expect("memory").minimum(), 1, "one page");
    // Soft floats in the functions of C are f32 at their border.
    assert!(on_a_plain_interpreter(c_layer()).is_err());
}

/// What of the README is about WebAssembly.
fn section() -> String {
    let readme = std::fs::read_to_string(format!("{ROOT}/README.md")).expect("README.md");
    let (_, section) = readme.split_once("# WebAssembly\n").expect("a section WebAssembly");
    let is_of_it = |line: &&str| !line.trim_start_matches('#').starts_with(' ') || !line.starts_with('#');
    section.lines().take_while(is_of_it).flat_map(|line| [line, "\n"]).collect()
}

/// The section's number before `unit`.
fn stated(unit: &str) -> f64 {
    let section = section();
    let (before, _) = section.split_once(unit).unwrap_or_else(|| panic!("the README does not say how many{unit}"));
    let number: String = before.chars().rev().take_while(|c| c.is_ascii_digit() || *c == ' ').collect();
    number.chars().rev().filter(char::is_ascii_digit).collect::<String>().parse().expect("a number")
}

/// Asserts that the README's number before `unit` is `actual`, give or take what compilers differ by.
fn assert_stated(actual: u64, unit: &str) {
    let (actual, stated) = (actual as f64, stated(unit));
    assert!((actual / stated - 1.0).abs() < 0.02, "the README states {stated}{unit}, which are {actual}");
}

#[test]
fn the_readme_has_this_module_and_these_commands() {
    let source = std::fs::read_to_string(format!("{ROOT}/tests/wasm/src/lib.rs")).expect("lib.rs");
    assert!(section().contains(&format!("`src/lib.rs`:\n\n```rust,ignore\n{source}```\n")));
    assert!(section().contains(BUILD_GLINT));
    let kinds = ["--crate-type cdylib --target wasm32-unknown-unknown", "-C link-arg=-zstack-size=8192"];
    assert!(kinds.iter().all(|kind| section().contains(kind) && BUILD_C_LAYER.contains(kind)));
}

#[test]
fn sizes_are_as_the_readme_states() {
    let bytes = glint().len() as u64;
    assert!((1024..4096).contains(&bytes), "{bytes} bytes");
    assert_stated(bytes, " bytes of module");
    assert_stated(Host::new(glint()).heap_base() as u64, " bytes of memory");
    assert_stated((c_layer().len() as u64 + 500) / 1000, " KB of module");
}

#[test]
fn fuel_is_as_the_readme_states() {
    let mut host = Scalars(Host::new(glint()));
    let mut most = [0; 4];
    let mut source = Source::new();
    for _ in 0..CASES {
        let [n, v, l] = [0; 3].map(|_: u8| host.normalize(source.lanes_q14()));
        let r = host.reflect(n, v);
        let calls: [&dyn Fn(&mut Scalars); 4] =
            [&|host| _ = host.normalize(v), &|host| _ = host.reflect(n, v), &|host| _ = host.cap(l, r), &|host| {
                _ = host.0.call::<_, i32>("glint_q14", (packed(n), packed(v), packed(l)))
            }];
        for (call, most) in calls.into_iter().zip(&mut most) {
            let before = host.0.fuel();
            call(&mut host);
            *most = before.saturating_sub(host.0.fuel()).max(*most);
        }
    }
    for (fuel, function) in most.into_iter().zip(["normalize_q14", "reflect_q14", "cap_q14", "glint_q14"]) {
        assert_stated(fuel, &format!(" for `{function}`"));
    }
}

/// Beyond the stack an address would be below 0, which traps.
#[test]
fn the_stack_is_large_enough() {
    const STACK: usize = 1024;
    let mut host = Scalars(Host::new(glint()));
    let memory = host.0.memory();
    memory.data_mut(&mut host.0.store)[..STACK].fill(0xa5);
    hash(&mut host);
    let untouched = memory.data(&host.0.store).iter().take_while(|&&byte| byte == 0xa5).count();
    assert!((1..=STACK / 4).contains(&(STACK - untouched)), "{} bytes of stack", STACK - untouched);
    assert_eq!(memory.size(&host.0.store), 1, "memory has grown");
}
