//! C on chips in QEMU, without a C library and without the compiler's: the same results as from Rust, and nothing linked
//! that is not needed.

use std::path::{Path, PathBuf};
use std::process::Command;

use embedding::library::{library, root, succeed};
use embedding::program::{HASHES, Program, expected};
use embedding::tools::found;

/// Bytes of flash that the README names for the least firmware with the Sun.
const FLASH: usize = 1204;

/// Bytes of stack that the README names for a call.
const STACK: usize = 184;

/// A core, with a board in `c` and a machine of QEMU that has it or a greater one.
struct Core {
    target: &'static str,
    board: &'static str,
    compiler: &'static str,
    options: &'static [&'static str],
    emulator: &'static str,
    machine: &'static [&'static str],
}

const M0_PLUS: Core = Core {
    target: "thumbv6m-none-eabi",
    board: "cortex_m",
    compiler: "arm-none-eabi-gcc",
    options: &["-mcpu=cortex-m0plus", "-mthumb", "-mfloat-abi=soft"],
    emulator: "qemu-system-arm",
    machine: &["-M", "mps2-an385"],
};

const M4F: Core = Core {
    target: "thumbv7em-none-eabihf",
    options: &["-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"],
    machine: &["-M", "mps2-an386"],
    ..M0_PLUS
};

const RV32IMC: Core = Core {
    target: "riscv32imc-unknown-none-elf",
    board: "riscv",
    compiler: "riscv64-unknown-elf-gcc",
    options: &["-march=rv32imc_zicsr", "-mabi=ilp32", "-mcmodel=medany"],
    emulator: "qemu-system-riscv32",
    machine: &["-M", "virt", "-bios", "none"],
};

/// A program that runs on nothing but the library.
const BARE: [&str; 5] = ["-Os", "-ffreestanding", "-ffunction-sections", "-nostdlib", "-Wl,--gc-sections"];

impl Core {
    /// Whether what it takes is there.
    fn found(&self) -> bool {
        let compilers = "apt-get install -y --no-install-recommends gcc-arm-none-eabi gcc-riscv64-unknown-elf";
        found(self.compiler, compilers) && found(self.emulator, "apt-get install -y qemu-system-arm qemu-system-misc")
    }

    fn build(&self, name: &str, sources: &[&str], library: &Path) -> PathBuf {
        let [board, places] = [format!("{}.c", self.board), format!("-T{}.ld", self.board)];
        let options = [self.options, &BARE[..], &[&places]].concat();
        let sources = [sources, &[&board]].concat();
        let program = Program { name: &format!("{name}-{}.elf", self.target), sources: &sources, options: &options };
        program.build(self.compiler, env!("CARGO_TARGET_TMPDIR"), library)
    }

    fn library(&self) -> PathBuf {
        library(Some(self.target))
    }

    fn firmware(&self, name: &str) -> PathBuf {
        self.build(name, &[&HASHES[..], &["firmware.c"]].concat(), &self.library())
    }

    /// What the program prints; the emulator has a minute.
    fn printed(&self, program: &Path) -> String {
        let mut emulator = Command::new("timeout");
        emulator.args(["60", self.emulator]).args(self.machine).args(["-nographic", "-monitor", "none"]);
        emulator.args(["-serial", "none", "-semihosting-config", "enable=on,target=native", "-kernel"]).arg(program);
        let output = emulator.output().unwrap();
        // Semihosting writes to the emulator's error output.
        let printed = String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned();
        assert!(output.status.success(), "{emulator:?}: {}\n{printed}", output.status);
        printed
    }
}

fn symbols(program: &Path) -> Vec<String> {
    let listed = succeed(Command::new("arm-none-eabi-nm").arg("--format=just-symbols").arg(program));
    listed.lines().map(str::to_owned).collect()
}

/// The compiler's routines for floats, by the names that arm has and by those that all have.
fn is_float(symbol: &str) -> bool {
    let one_of = |name: &str, starts: &[&str]| starts.iter().any(|start| name.starts_with(start));
    symbol.strip_prefix("__aeabi_").is_some_and(|rest| one_of(rest, &["f", "d", "i2", "ui2", "l2", "ul2"]))
        || one_of(symbol, &["__add", "__sub", "__mul", "__div", "__float", "__fix"])
            && (symbol.contains("sf") || symbol.contains("df"))
}

fn is_panic(symbol: &str) -> bool {
    symbol.contains("panic") || symbol.contains("unwind")
}

fn results_are_those_of_rust(core: &Core) {
    if core.found() {
        assert_eq!(core.printed(&core.firmware("hashes")), expected());
    }
}

#[test]
fn results_on_the_least_core_are_those_of_rust() {
    results_are_those_of_rust(&M0_PLUS);
}

#[test]
fn results_are_the_same_with_floats_in_registers() {
    results_are_those_of_rust(&M4F);
}

#[test]
fn results_on_risc_v_are_those_of_rust() {
    results_are_those_of_rust(&RV32IMC);
}

/// With all functions linked, those of floats too, which compute in integers.
#[test]
fn no_float_code_and_no_panic_is_linked() {
    if M0_PLUS.found() {
        let symbols = symbols(&M0_PLUS.firmware("symbols"));
        assert!(symbols.iter().any(|symbol| symbol == "sunglint_cap_q14"));
        let unwanted: Vec<_> = symbols.iter().filter(|symbol| is_float(symbol) || is_panic(symbol)).collect();
        assert!(unwanted.is_empty(), "{unwanted:?}");
    }
}

#[test]
fn planted_float_code_is_found() {
    if M0_PLUS.found() {
        let planted = M0_PLUS.build("planted_float", &["planted_float.c"], &M0_PLUS.library());
        assert!(symbols(&planted).iter().any(|symbol| is_float(symbol)));
    }
}

#[test]
fn a_planted_panic_is_found() {
    if M0_PLUS.found() {
        let library = Path::new(env!("CARGO_TARGET_TMPDIR")).join("libplanted_panic.a");
        let mut compiler = Command::new("rustc");
        compiler.args([
            "--edition=2024",
            "--crate-type=staticlib",
            "-Copt-level=s",
            "-Clto=fat",
            "-Cpanic=abort",
            "--target",
        ]);
        compiler.arg(M0_PLUS.target).arg("c/planted_panic.rs").arg("-o").arg(&library);
        succeed(&mut compiler);
        let planted = M0_PLUS.build("planted_panic", &["minimal.c"], &library);
        assert!(symbols(&planted).iter().any(|symbol| is_panic(symbol)));
    }
}

/// Within a twentieth, since compilers differ.
fn is_about(measured: usize, named: usize) -> bool {
    (named * 19 / 20..=named * 21 / 20).contains(&measured)
}

#[test]
fn the_least_firmware_takes_the_flash_that_the_readme_names() {
    if M0_PLUS.found() {
        let minimal = M0_PLUS.build("minimal", &["minimal.c"], &M0_PLUS.library());
        let sizes = succeed(Command::new("arm-none-eabi-size").arg(&minimal));
        // Of text and data in the second line.
        let flash: usize =
            sizes.lines().nth(1).unwrap().split_whitespace().take(2).map(|bytes| bytes.parse::<usize>().unwrap()).sum();
        assert!(is_about(flash, FLASH), "{flash}");
        assert_eq!(M0_PLUS.printed(&minimal), "");
    }
}

#[test]
fn a_call_takes_the_stack_that_the_readme_names() {
    if M0_PLUS.found() {
        let printed = M0_PLUS.printed(&M0_PLUS.build("stack", &["stack.c"], &M0_PLUS.library()));
        assert!(printed.trim().parse().is_ok_and(|stack| is_about(stack, STACK)), "{printed}");
    }
}

#[test]
fn the_readme_names_those_bytes() {
    let readme = std::fs::read_to_string(root().join("README.md")).unwrap();
    for named in [format!("{FLASH} bytes of flash"), format!("{STACK} bytes of stack")] {
        assert!(readme.contains(&named), "the README does not say {named}");
    }
}
