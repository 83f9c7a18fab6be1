//! Modules as the README builds them, and hosts that call them.

use std::process::Command;
use std::sync::OnceLock;

use embedding::hashes::{CASES, Hash, Source};
use sunglint::capi::SphereQ14;
use wasmi::{CompilationMode, Config, Engine, Instance, Memory, Module, Store, WasmParams, WasmResults};

/// The README's command for `glint`.
pub const BUILD_GLINT: &str = r#"cargo rustc --release --crate-type cdylib --target wasm32-unknown-unknown \
  --config profile.release.lto=true --config 'profile.release.opt-level="s"' --config profile.release.strip=true \
  -- -C link-arg=-zstack-size=1024"#;

/// The README's command for the functions of C, of which this end is in the section on WebAssembly.
pub const BUILD_C_LAYER: &str = r#"cargo rustc --lib --profile embedded --no-default-features --features capi \
  --crate-type cdylib --target wasm32-unknown-unknown -- --cfg freestanding -C link-arg=-zstack-size=8192"#;

/// The project's folder.
pub const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// A vector.
pub type Lanes = [i16; 3];

/// Runs a command of the README in a folder of the project, and reads the module that it makes.
fn built(command: &str, folder: &str, module: &str) -> Vec<u8> {
    let target = format!("{ROOT}/target/embedding");
    let status = Command::new("sh")
        .args(["-c", command])
        .current_dir(format!("{ROOT}/{folder}"))
        .env("CARGO_TARGET_DIR", &target)
        .status()
        .expect("sh");
    assert!(status.success(), "{command}");
    let file = path(module);
    std::fs::read(&file).expect(&file)
}

/// Where a module is, once it is built.
pub fn path(module: &str) -> String {
    format!("{ROOT}/target/embedding/wasm32-unknown-unknown/{module}")
}

/// The module of scalars.
pub const GLINT: &str = "release/glint.wasm";
/// The module of the functions of C.
pub const C_LAYER: &str = "embedded/sunglint.wasm";

/// Builds the module of scalars, once.
pub fn glint() -> &'static [u8] {
    static MODULE: OnceLock<Vec<u8>> = OnceLock::new();
    MODULE.get_or_init(|| built(BUILD_GLINT, "tests/wasm", GLINT))
}

/// Builds the module of the functions of C, once.
pub fn c_layer() -> &'static [u8] {
    static MODULE: OnceLock<Vec<u8>> = OnceLock::new();
    MODULE.get_or_init(|| built(BUILD_C_LAYER, ".", C_LAYER))
}

/// A module under wasmi, with fuel.
pub struct Host {
    /// Whose memory and fuel it has.
    pub store: Store<()>,
    instance: Instance,
}

impl Host {
    /// Without anything to import.
    pub fn new(wasm: &[u8]) -> Self {
        let mut config = Config::default();
        // Else the first call pays for being translated.
        config.consume_fuel(true).compilation_mode(CompilationMode::Eager);
        let engine = Engine::new(&config);
        let module = Module::new(&engine, wasm).expect("a module");
        let mut store = Store::new(&engine, ());
        store.set_fuel(u64::MAX).expect("fuel is on");
        let instance = Instance::new(&mut store, &module, &[]).expect("nothing to import");
        Self { store, instance }
    }

    /// Calls an exported function.
    pub fn call<P: WasmParams, R: WasmResults>(&mut self, name: &str, given: P) -> R {
        let function = self.instance.get_typed_func::<P, R>(&self.store, name).expect(name);
        function.call(&mut self.store, given).expect(name)
    }

    /// What is left.
    pub fn fuel(&self) -> u64 {
        self.store.get_fuel().expect("fuel is on")
    }

    /// All of the module's.
    pub fn memory(&self) -> Memory {
        self.instance.get_memory(&self.store, "memory").expect("memory")
    }

    /// Where its data ends.
    pub fn heap_base(&self) -> usize {
        let global = self.instance.get_global(&self.store, "__heap_base").expect("__heap_base");
        global.get(&self.store).i32().expect("an address") as usize
    }
}

/// What `directions_q14` calls.
pub trait Directions {
    /// The vector of length 1.
    fn normalize(&mut self, v: Lanes) -> Lanes;
    /// The mirror ray.
    fn reflect(&mut self, n: Lanes, v: Lanes) -> Lanes;
    /// What of the light is nearest to it.
    fn cap(&mut self, l: Lanes, r: Lanes) -> Lanes;
}

/// The module `glint`.
pub struct Scalars(pub Host);

/// As the module takes it.
pub fn packed([x, y, z]: Lanes) -> i64 {
    i64::from(x as u16) | i64::from(y as u16) << 16 | i64::from(z as u16) << 32
}

/// As the module gives it.
fn lanes(v: i64) -> Lanes {
    assert_eq!(v >> 48, 0, "three lanes leave the upper bits free");
    [v as i16, (v >> 16) as i16, (v >> 32) as i16]
}

impl Directions for Scalars {
    fn normalize(&mut self, v: Lanes) -> Lanes {
        lanes(self.0.call("normalize_q14", packed(v)))
    }

    fn reflect(&mut self, n: Lanes, v: Lanes) -> Lanes {
        lanes(self.0.call("reflect_q14", (packed(n), packed(v))))
    }

    fn cap(&mut self, l: Lanes, r: Lanes) -> Lanes {
        lanes(self.0.call("cap_q14", (packed(l), packed(r))))
    }
}

/// The functions of C. A struct is passed as its address, and a function that returns one is given, first, the address to
/// write it to. Memory from `__heap_base` on is the host's.
pub struct Structs {
    /// Where they run.
    pub host: Host,
    base: i32,
    light: SphereQ14,
}

impl Structs {
    /// With the light that `cap` is given.
    pub fn new(wasm: &[u8], light: SphereQ14) -> Self {
        let host = Host::new(wasm);
        let base = host.heap_base() as i32;
        Self { host, base, light }
    }

    /// Where the host has its `slot`th struct, each of at most 128 bytes.
    pub fn at(&self, slot: i32) -> i32 {
        self.base + 128 * slot
    }

    /// Writes what a call is to be given.
    pub fn write(&mut self, slot: i32, bytes: &[u8]) {
        let address = self.at(slot) as usize;
        self.host.memory().write(&mut self.host.store, address, bytes).expect("room for it");
    }

    /// Reads what a call has written.
    pub fn read<const N: usize>(&self, slot: i32) -> [u8; N] {
        let mut bytes = [0; N];
        self.host.memory().read(&self.host.store, self.at(slot) as usize, &mut bytes).expect("what was written");
        bytes
    }

    fn write_lanes(&mut self, slot: i32, lanes: Lanes) {
        self.write(slot, lanes.map(i16::to_le_bytes).as_flattened());
    }

    fn result_lanes(&self) -> Lanes {
        let [a, b, c, d, e, f] = self.read(0);
        [[a, b], [c, d], [e, f]].map(i16::from_le_bytes)
    }
}

impl Directions for Structs {
    fn normalize(&mut self, v: Lanes) -> Lanes {
        self.write_lanes(1, v);
        self.host.call::<_, ()>("sunglint_normalize_q14", (self.at(0), self.at(1)));
        self.result_lanes()
    }

    fn reflect(&mut self, n: Lanes, v: Lanes) -> Lanes {
        self.write_lanes(1, n);
        self.write_lanes(2, v);
        self.host.call::<_, ()>("sunglint_reflect_q14", (self.at(0), self.at(1), self.at(2)));
        self.result_lanes()
    }

    fn cap(&mut self, l: Lanes, r: Lanes) -> Lanes {
        let SphereQ14 { sin, sin_square, cos, versine } = self.light;
        self.write_lanes(1, l);
        self.write_lanes(2, r);
        self.write(3, [sin, sin_square, cos, versine].map(i32::to_le_bytes).as_flattened());
        self.host.call::<_, ()>("sunglint_cap_q14", (self.at(0), self.at(1), self.at(2), self.at(3)));
        self.result_lanes()
    }
}

/// What `directions_q14` is by functions that are elsewhere.
pub fn hash(directions: &mut dyn Directions) -> u32 {
    let (mut source, mut hash) = (Source::new(), Hash::new());
    for _ in 0..CASES {
        let [n, v, l] = [0; 3].map(|_: u8| directions.normalize(source.lanes_q14()));
        let r = directions.reflect(n, v);
        [n, v, l, r, directions.cap(l, r)].into_iter().for_each(|lanes| hash.add_q14(lanes));
    }
    hash.0
}
