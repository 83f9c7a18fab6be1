//! Raw bits as they are typed, and numbers as they are shown.

use comfy_table::Table;
use sunglint::trial::Format;

use crate::failure::Failure;
use crate::table;

/// Three numbers of `format` from hexadecimal digits, with or without 0x, apart by spaces or commas. `name` is that of
/// the argument.
pub fn read(name: &str, bits: &str, format: Format) -> Result<[f64; 3], Failure> {
    let most = u64::MAX >> (64 - format.width());
    let number = |digits: &str| {
        let plain = digits.strip_prefix("0x").or_else(|| digits.strip_prefix("0X")).unwrap_or(digits);
        let hexadecimal = !plain.is_empty() && plain.chars().all(|digit| digit.is_ascii_hexdigit());
        if !hexadecimal {
            let what = "is no number in hexadecimal";
            return Err(Failure::Usage(format!("'{digits}' in {name} {what}, allowed is 0 to {most:x}")));
        }
        let outside =
            || Failure::Usage(format!("{plain} in {name} is no number of {}, allowed is 0 to {most:x}", format.name()));
        // What 64 bits cannot hold fails here.
        let bits = u64::from_str_radix(plain, 16).ok().filter(|bits| *bits <= most);
        bits.map(|bits| format.value(bits)).ok_or_else(outside)
    };
    let numbers = bits.split([' ', ',']).filter(|digits| !digits.is_empty()).map(number);
    let numbers = numbers.collect::<Result<Vec<_>, _>>()?;
    let count = numbers.len();
    numbers.try_into().map_err(|_| Failure::Usage(format!("{name} has {count} numbers, allowed is 3")))
}

/// An empty table of numbers.
pub fn table() -> Table {
    table::table(&["", "", "raw bits", "value"])
}

/// Adds a vector that the format holds.
pub fn add(table: &mut Table, name: &str, format: Format, lanes: [f64; 3]) {
    let bits = lanes.map(|lane| crate::measure::bits(format, &[lane]));
    add_lanes(table, name, bits, lanes.map(exact));
}

/// Adds a vector in f64, which the format does not hold.
pub fn add_truth(table: &mut Table, name: &str, lanes: [f64; 3]) {
    add_lanes(table, name, [""; 3].map(str::to_owned), lanes.map(|lane| lane.to_string()));
}

fn add_lanes(table: &mut Table, name: &str, bits: [String; 3], values: [String; 3]) {
    let names = [name, "", ""];
    for (((name, axis), bits), value) in names.into_iter().zip(["x", "y", "z"]).zip(bits).zip(values) {
        table.add_row([name, axis, &bits, &value]);
    }
}

/// All digits of a number; of tiny ones with a power of ten.
pub fn exact(value: f64) -> String {
    if !value.is_finite() || value == 0.0 {
        return value.to_string();
    }
    if value.abs() >= 1e-4 {
        let digits = format!("{value:.1074}");
        return digits.trim_end_matches('0').trim_end_matches('.').to_owned();
    }
    let digits = format!("{value:.800e}");
    let (digits, power) = digits.split_once('e').unwrap_or((&digits, "0"));
    format!("{}e{power}", digits.trim_end_matches('0').trim_end_matches('.'))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bits_are_read_however_they_are_apart() {
        for bits in ["3c00 bc00 0", "0x3c00,0xBC00,0x0000", " 3c00, bc00  0,"] {
            assert_eq!(read("--l", bits, Format::F16).ok(), Some([1.0, -1.0, 0.0]), "{bits}");
        }
        assert!(read("--l", "1 2 10000000000000000", Format::F64).is_err(), "65 bits");
        assert!(read("--l", "1 2 +3", Format::F64).is_err() && read("--l", "", Format::F64).is_err());
    }

    #[test]
    fn every_digit_is_shown() {
        assert_eq!(exact(16383.0 / 16384.0), "0.99993896484375");
        assert_eq!(exact(f64::from(0.1_f32)), "0.100000001490116119384765625");
        assert_eq!([exact(0.0), exact(-2.0), exact(f64::NAN), exact(5e-5)].concat(), {
            "0-2NaN5.00000000000000023960868011929647991564706899225711822509765625e-5"
        });
        let least = exact(f64::from_bits(1));
        assert!(least.starts_with("4.94065645841246544") && least.ends_with("5e-324") && least.len() > 700);
    }
}
