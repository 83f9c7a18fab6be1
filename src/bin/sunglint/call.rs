//! What is called: a function in a number format, by whatever row of the study it is measured.

use crate::chip::PIXEL;
use crate::result::{KernelRow, PixelRow, Row};

/// Something that can be called, and what it costs on this machine.
#[derive(Clone, Debug)]
pub struct Call {
    /// Name of the function, as the table of counts has it.
    pub function: String,
    /// Name of the number format.
    pub format: String,
    /// Whose code it is.
    pub by: &'static str,
    /// Median and quartiles of its time.
    pub host: [f64; 3],
}

impl Row {
    /// What is called, and its time.
    pub fn call(&self) -> Call {
        called([&self.method, &self.format], self.by, [self.cost, self.cost_low, self.cost_high])
    }
}

impl PixelRow {
    /// What is called, and its time.
    pub fn call(&self) -> Call {
        let host = [self.cost, self.cost_low, self.cost_high];
        called([&format!("{PIXEL}{}", self.method), &self.format], self.by, host)
    }
}

impl KernelRow {
    /// What is called, and its time.
    pub fn call(&self) -> Call {
        called([&self.kernel, &self.format], self.by, [self.cost, self.cost_low, self.cost_high])
    }
}

fn called([function, format]: [&str; 2], by: &'static str, host: [f64; 3]) -> Call {
    Call { function: function.to_owned(), format: format.to_owned(), by, host }
}
