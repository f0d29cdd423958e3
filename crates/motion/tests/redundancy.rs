//! explore
use seamwright_machine::{Machine, shipped};
use seamwright_motion::{PassMotion, redundancy};
use seamwright_program::TorchPath;
use seamwright_weld::Welding;
use std::time::Instant;

#[test]
fn explore() {
    let w = Welding::read("e", include_str!("../../../examples/oblique-girth.toml")).unwrap_or_else(|e| panic!("{e}"));
    let m = Machine::read("m", shipped("ebw-7axis").unwrap().text).unwrap();
    let pass = &w.program.value.passes[0];
    let path = w.path(0);
    let t = Instant::now();
    let free = redundancy::resolve(&m, &path, 10.0, &pass.spare_axes, None, 1).unwrap();
    println!("resolve {:?}", t.elapsed());
    let t = Instant::now();
    let plan = PassMotion::plan(&m, &path, pass, 1);
    println!("plan {:?}", t.elapsed());
    let mut q = free.start().unwrap();
    for i in 0..=40 {
        let s = path.length() * f64::from(i) / 40.0;
        q = m.inverse_near(path.pose(s), &free.at(s, &q)).unwrap().joints;
        let tilt = m.up_in_work(&q).dot(path.face(s)).acos().to_degrees();
        println!(
            "{s:8.1} {} flat {tilt:.3}",
            m.axes.iter().zip(&q).map(|(a, v)| format!("{} {:9.3} ", a.name, a.to_file(*v))).collect::<String>()
        );
    }
    let plan = plan.unwrap_or_else(|f| panic!("{f:#?}"));
    println!("{:#?} {:?} {}", plan.findings, plan.law.report(), plan.total_s());
}
