use super::*;
use ts_rs::{Config, TS};

fn decl<T: TS>(config: &Config) -> String {
    let docs = T::docs().unwrap_or_default();
    format!("{docs}export {}\n", T::decl(config))
}

/// Returns the panel's declarations of all types that cross the wire.
pub fn typescript() -> String {
    let config = Config::default();
    let declarations = [
        decl::<MessageView>(&config),
        decl::<ArgumentView>(&config),
        decl::<QuantityView>(&config),
        decl::<MachineView>(&config),
        decl::<AxisView>(&config),
        decl::<AlarmEntry>(&config),
        decl::<ConditionView>(&config),
        decl::<ZoneView>(&config),
        decl::<FrameView>(&config),
        decl::<JointView>(&config),
        decl::<SensorView>(&config),
        decl::<DeviceView>(&config),
        decl::<SignalView>(&config),
        decl::<TrafficView>(&config),
        decl::<TuningView>(&config),
        decl::<ParametersView>(&config),
        decl::<AxisParameters>(&config),
        decl::<ParameterView>(&config),
        decl::<HeadView>(&config),
        decl::<ParameterChange>(&config),
        decl::<ToolTouches>(&config),
        decl::<ToolAnswer>(&config),
        decl::<ToolTip>(&config),
        decl::<SensorsView>(&config),
        decl::<SensorSetUp>(&config),
        decl::<SensorValue>(&config),
        decl::<HeightView>(&config),
        decl::<SensorChange>(&config),
        decl::<SensorAnswer>(&config),
        decl::<SessionView>(&config),
        decl::<Stopped>(&config),
        decl::<Role>(&config),
        decl::<Login>(&config),
        decl::<UserRow>(&config),
        decl::<UserChange>(&config),
        decl::<OwnPassword>(&config),
        decl::<ArchiveView>(&config),
        decl::<Trouble>(&config),
        decl::<Status>(&config),
        decl::<StandingView>(&config),
        decl::<LeftView>(&config),
        decl::<RealtimeView>(&config),
        decl::<ProcessStatus>(&config),
        decl::<AxisStatus>(&config),
        decl::<TrackingStatus>(&config),
        decl::<Ages>(&config),
        decl::<AlarmView>(&config),
        decl::<WhoWhen>(&config),
        decl::<Shelving>(&config),
        decl::<EventView>(&config),
        decl::<LackView>(&config),
        decl::<WorkView>(&config),
        decl::<PassView>(&config),
        decl::<PathPoint>(&config),
        decl::<CertificateView>(&config),
        decl::<BoundView>(&config),
        decl::<UseView>(&config),
        decl::<NearView>(&config),
        decl::<SectionView>(&config),
        decl::<BeadView>(&config),
        decl::<DraftAnswer>(&config),
        decl::<PlaceText>(&config),
        decl::<PlaceMethod>(&config),
        decl::<TouchedPoint>(&config),
        decl::<PlaceAnswer>(&config),
        decl::<FindingView>(&config),
        decl::<SolidView>(&config),
        decl::<ShapeView>(&config),
        decl::<PlanAnswer>(&config),
        decl::<WrongView>(&config),
        decl::<FormText>(&config),
        decl::<FormChange>(&config),
        decl::<FormAnswer>(&config),
        decl::<FormView>(&config),
        decl::<FormTable>(&config),
        decl::<FormEntry>(&config),
        decl::<RangeView>(&config),
        decl::<FormValue>(&config),
        decl::<AddableView>(&config),
        decl::<PointsView>(&config),
        decl::<PointRow>(&config),
        decl::<JobText>(&config),
        decl::<PlanningView>(&config),
        decl::<JobKept>(&config),
        decl::<JobRow>(&config),
        decl::<ChoicesView>(&config),
        decl::<Choice>(&config),
        decl::<DistortionRow>(&config),
        decl::<Load>(&config),
        decl::<PostText>(&config),
        decl::<PostAnswer>(&config),
        decl::<EditAnswer>(&config),
        decl::<AuditRow>(&config),
        decl::<RecordRow>(&config),
        decl::<RecordView>(&config),
        decl::<JudgedView>(&config),
        decl::<RecordedAlarm>(&config),
        decl::<RecordedEvent>(&config),
        decl::<TraceView>(&config),
        decl::<TeachOrder>(&config),
        decl::<TeachPhase>(&config),
        decl::<TeachView>(&config),
        decl::<TaughtView>(&config),
        decl::<TaughtPointView>(&config),
        decl::<TaughtLook>(&config),
        decl::<TeachProgram>(&config),
        decl::<TaughtProgram>(&config),
        decl::<ToCell>(&config),
        decl::<JogOf>(&config),
        decl::<AskView>(&config),
        decl::<FromCell>(&config),
    ];
    format!("// Made from crates/server/src/wire by its test: do not change by hand.\n\n{}", declarations.join("\n"))
}

#[cfg(test)]
mod tests {
    /// `SEAMWRIGHT_BLESS=1` rewrites the file.
    #[test]
    fn the_panels_types_are_those_of_the_wire() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../web/src/wire.ts");
        let made = super::typescript();
        if std::env::var_os("SEAMWRIGHT_BLESS").is_some() {
            std::fs::write(path, &made).unwrap();
        }
        assert!(std::fs::read_to_string(path).unwrap() == made, "{path}: SEAMWRIGHT_BLESS=1 writes it anew");
    }
}
