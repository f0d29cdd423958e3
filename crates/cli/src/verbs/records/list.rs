use super::data::open;
use crate::args::records::ListArgs;
use crate::rows::{Cell, Rows};
use seamwright_project::failure::Failure;
use seamwright_record::library::Query;

const HEADER: &str =
    "id,part,begun,ended,result,simulated,title,machine,procedure,welder,heat_input_mean_kj_mm,worst_deviation_mm";

pub(super) fn run(args: &ListArgs) -> Result<(), Failure> {
    let data = open(args.data.data.as_deref())?;
    let query = Query {
        part: args.part.clone(),
        since: args.since,
        until: args.until,
        program: None,
        procedure: args.procedure.clone(),
        machine: args.machine.clone(),
        result: args.result,
        text: args.text.clone(),
        limit: None,
    };
    let welds = data.library().find(&query)?;
    let mut rows = Rows::with_header(HEADER, args.data.json);
    for weld in &welds {
        let (begun, ended) = (weld.begun.to_string(), weld.ended.map(|m| m.to_string()));
        let number = |value: Option<f64>| value.map_or(Cell::Empty, Cell::Number);
        let procedure = weld.procedure.as_ref().map(|p| p.0.as_str());
        rows.row(&[
            Cell::Count(weld.id.unsigned_abs()),
            Cell::Text(&weld.part),
            Cell::Text(&begun),
            text(ended.as_deref()),
            Cell::Text(weld.result.name()),
            Cell::Count(u64::from(weld.simulated)),
            Cell::Text(&weld.title),
            Cell::Text(&weld.machine.0),
            text(procedure),
            text(weld.welder.as_deref()),
            number(weld.heat_input_kj_mm.map(|h| h[1])),
            number(weld.worst_deviation_mm.map(|d| d.0)),
        ])?;
    }
    rows.finish()
}

fn text(text: Option<&str>) -> Cell<'_> {
    text.map_or(Cell::Empty, Cell::Text)
}
