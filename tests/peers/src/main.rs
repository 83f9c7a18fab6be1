//! Prints what the peers cost on this machine; with `--errors` the worst errors of the kernels for microcontrollers, as
//! `src/trial/chip/peers.csv` has them.

use comfy_table::{Table, presets::UTF8_FULL_CONDENSED};
use peers::{callgrind, contest, kernel_error, throughput};

const ROUNDS: usize = 101;

fn main() {
    if callgrind::answered() {
        return;
    }
    if std::env::args().any(|argument| argument == "--errors") {
        println!("{}", kernel_error::HEADER);
        kernel_error::rows().iter().for_each(|row| println!("{}", kernel_error::line(row)));
        return;
    }
    println!("{}", beside_glam());
    println!("{}", in_loops());
}

fn table(header: &[&str]) -> Table {
    let mut table = Table::new();
    table.load_preset(UTF8_FULL_CONDENSED).set_header(header);
    table
}

fn beside_glam() -> Table {
    let mut table =
        table(&["f32", "over glam 0.34.3", "time over glam's", "instructions", "glam's", "worst error", "glam's", ""]);
    let mut missing = None;
    for (index, contest) in contest::ALL.iter().enumerate() {
        let contest = contest();
        let ratio = format!("{:.2}", contest.ratio(ROUNDS).median);
        let errors = (contest.errors)().map(|error| format!("{error:.1e}"));
        let [own, other] = callgrind::instructions(index, [&contest.own, &contest.other]).map_or_else(
            |error| {
                missing = Some(error);
                ["-".to_owned(), "-".to_owned()]
            },
            |counts| counts.map(|count| format!("{count:.0}")),
        );
        let [own_error, other_error] = errors;
        let row = [contest.function, contest.peer, &ratio, &own, &other, &own_error, &other_error, contest.unit];
        table.add_row(row);
    }
    if let Some(error) = missing {
        eprintln!("LEFT OUT: instructions, which Valgrind counts (apt-get install -y valgrind): {error}");
    }
    table
}

fn in_loops() -> Table {
    let mut table = table(&["a million pixels in a loop", "format", "time over f32's", "time over as many calls"]);
    for row in throughput::rows(21) {
        let ratios = [row.over_f32, row.over_calls].map(|ratio| format!("{ratio:.2}"));
        table.add_row([row.function, row.format, &ratios[0], &ratios[1]]);
    }
    table
}
