use crate::wire::Role;

/// Minimum role of each action: the single table, checked on the server and shown to the panel. Commands have the names
/// of [`crate::wire::AskView`].
pub(crate) const NEEDS: [(&str, Role); 35] = [
    ("stop", Role::Viewer),
    ("hold", Role::Operator),
    ("switch_on", Role::Operator),
    ("switch_off", Role::Operator),
    ("home", Role::Operator),
    ("start_jog", Role::Operator),
    ("jog", Role::Operator),
    ("start_teach", Role::Programmer),
    ("teach", Role::Programmer),
    ("start_dry_run", Role::Operator),
    ("arm", Role::Operator),
    ("start_weld", Role::Operator),
    ("resume", Role::Operator),
    ("reverse", Role::Operator),
    ("override", Role::Operator),
    ("reset", Role::Operator),
    ("acknowledge", Role::Operator),
    ("take_control", Role::Operator),
    ("watch", Role::Viewer),
    ("jobs.read", Role::Viewer),
    ("jobs.write", Role::Programmer),
    ("plan", Role::Operator),
    ("edit", Role::Programmer),
    ("post", Role::Programmer),
    ("load", Role::Operator),
    ("records.read", Role::Viewer),
    ("tune", Role::Service),
    ("set_up", Role::Service),
    ("shelve", Role::Service),
    ("audit.read", Role::Service),
    ("diagnose", Role::Service),
    ("backup", Role::Service),
    ("restore", Role::Admin),
    ("users.read", Role::Admin),
    ("users.write", Role::Admin),
];

/// Returns the minimum role of an action; `None`: not in the table, so forbidden.
pub(crate) fn least(action: &str) -> Option<Role> {
    NEEDS.iter().find(|(name, _)| *name == action).map(|(_, role)| *role)
}

/// Returns true if `role` may do this.
pub(crate) fn may(role: Role, action: &str) -> bool {
    least(action).is_some_and(|needed| role >= needed)
}
