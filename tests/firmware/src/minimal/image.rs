//! The images, and what is measured of one.

use std::path::Path;
use std::process::Command;

use sunglint::trial::Format;

use crate::inputs::{self, By};
use crate::{elf, pixels, ram};

/// Bytes of code and of tables, and of stack at the deepest.
pub type Cost = [u32; 3];

/// One of the bins of the crate `minimal`.
pub struct Image {
    bin: &'static str,
    function: &'static str,
    format: Format,
    by: &'static str,
}

/// By this crate, in the format's own arithmetic.
const OWN: &str = "sunglint";

const fn cap(bin: &'static str, format: Format) -> Image {
    Image { bin, function: "cap", format, by: OWN }
}

const fn pixel(bin: &'static str, format: Format) -> Image {
    Image { bin, function: "pixel disc_ggx", format, by: OWN }
}

/// In the order of the table.
pub const IMAGES: [Image; 17] = [
    Image { bin: "nothing", function: "nothing", format: Format::I2F14, by: OWN },
    cap("cap_i2f14", Format::I2F14),
    cap("cap_i2f30", Format::I2F30),
    cap("cap_i16f16", Format::I16F16),
    Image { bin: "cap_soft", function: "cap", format: Format::F32, by: "sunglint soft" },
    cap("cap_f32", Format::F32),
    cap("cap_micromath", Format::Micromath),
    cap("cap_f16", Format::F16),
    cap("cap_f64", Format::F64),
    Image { bin: "pixel_q14", function: "pixel disc_ggx", format: Format::I2F14, by: "PixelQ14" },
    pixel("pixel_i2f14", Format::I2F14),
    pixel("pixel_i2f30", Format::I2F30),
    pixel("pixel_i16f16", Format::I16F16),
    pixel("pixel_f32", Format::F32),
    pixel("pixel_micromath", Format::Micromath),
    pixel("pixel_f16", Format::F16),
    pixel("pixel_f64", Format::F64),
];

impl Image {
    /// Function, format and author, as the table has them.
    pub fn key(&self) -> String {
        format!("{},{},{}", self.function, self.format.name(), self.by)
    }

    /// Runs it and measures what it took, and stops where it has computed anything else than this machine.
    pub fn measure(&self, folder: &Path, target: &str) -> Cost {
        let image = folder.join(target).join("release").join(self.bin);
        let memory = folder.join("fresh").join(format!("{target}.{}.ram", self.bin));
        let [text, rodata] = elf::bytes(&image);
        self.check_floats(&image, target);
        ram::prepare(&memory, &inputs::bytes(self.format));
        emulate(target, &image, &memory);
        let outcome = ram::read(&memory);
        assert!(outcome.answers.starts_with(&self.expected()), "{target}: {}", self.key());
        std::fs::remove_file(&memory).expect("the RAM is a file of this folder");
        [text, rodata, outcome.stack]
    }

    /// The answers that it has to give.
    fn expected(&self) -> Vec<u8> {
        match (self.function, self.by) {
            ("nothing", _) => By::Nobody.answers(self.format),
            ("cap", "sunglint soft") => By::Soft.answers(self.format),
            ("cap", _) => By::Formula.answers(self.format),
            (_, "PixelQ14") => pixels::by_pixel_q14(),
            _ => pixels::answers(self.format),
        }
    }

    /// Integer images have no float code, and the search for it finds what is there.
    fn check_floats(&self, image: &Path, target: &str) {
        let integers = matches!(self.format, Format::I2F14 | Format::I2F30 | Format::I16F16) || self.by != OWN;
        let hardware = target.ends_with("hf") && matches!(self.format, Format::F32 | Format::Micromath);
        if !hardware {
            assert_eq!(has_float_code(image), !integers, "{target}: float code in {}", self.key());
        }
    }
}

/// Whether any symbol is of a float routine: the names of Arm, the compiler's library and others.
fn has_float_code(path: &Path) -> bool {
    const NAMES: [&str; 9] = [
        "__aeabi_f",
        "__aeabi_d",
        "__aeabi_i2",
        "__aeabi_ui2",
        "__aeabi_l2",
        "__aeabi_ul2",
        "sf3\0",
        "df3\0",
        "5float",
    ];
    let file = std::fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let named = |name: &str| file.windows(name.len()).any(|bytes| bytes == name.as_bytes());
    NAMES.into_iter().any(named)
}

/// Until it ends; ten times what the slowest takes.
fn emulate(target: &str, image: &Path, memory: &Path) {
    let (emulator, machine, options): (_, _, &[&str]) = match target {
        "riscv32imc-unknown-none-elf" => ("qemu-system-riscv32", "virt", &["-m", "16M", "-bios", "none"]),
        "thumbv7em-none-eabihf" => ("qemu-system-arm", "mps2-an386", &[]),
        _ => ("qemu-system-arm", "mps2-an385", &[]),
    };
    let output = Command::new("timeout")
        .args(["60", emulator, "-machine", &format!("{machine},memory-backend=ram"), "-object"])
        .arg(format!("memory-backend-file,id=ram,size=16M,share=on,mem-path={}", memory.display()))
        .args(["-nographic", "-semihosting-config", "enable=on,target=native", "-kernel"])
        .arg(image)
        .args(options)
        .stdin(std::process::Stdio::null())
        .output()
        .expect("QEMU, which run has found");
    assert!(output.status.success(), "{target}: {}\n{}", image.display(), String::from_utf8_lossy(&output.stderr));
}
