use super::display_distances::Around;
use super::event::Happening;
use super::tally::Tally;
use crate::limits::{
    MAX_PAGES, MAX_PAGES_OF_USER, MAX_VIEWER_PAGES, MAX_WAITING_MESSAGES, PAGES_KEPT_FOR_OPERATORS, RECENT_EVENTS,
};
use crate::view::written;
use crate::wire::{
    AlarmView, CountView, EventView, FromCell, NearView, RefusedView, Role, Status, TeachView, WorkView,
};
use seamwright_executive::devices::Traffic;
use seamwright_machine::{Joints, Machine};
use seamwright_record::Moment;
use seamwright_record::library::WeldResult;
use std::collections::{BTreeMap, HashMap, VecDeque};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};
use tokio::sync::{mpsc, watch};

/// The control token is lost after this time without a heartbeat.
const BEAT: Duration = Duration::from_secs(1);

/// A client: its station, its messages in order, the newest status.
pub(crate) type Connected = (u32, mpsc::Receiver<Text>, watch::Receiver<Option<Text>>);

/// A message as sent over the socket.
pub(crate) type Text = Arc<str>;

/// State that all clients see: the newest status, events and alarms without loss, the control token.
#[derive(Default)]
pub(crate) struct Hub {
    status: watch::Sender<Option<Text>>,
    latest: Mutex<Option<(Status, Joints)>>,
    near: Mutex<Option<NearView>>,
    /// Time of the last status of the cycle.
    shown: Mutex<Option<Instant>>,
    tally: Mutex<Tally>,
    /// Recorded welds by the name of their result.
    welds: Mutex<BTreeMap<&'static str, u64>>,
    told: Mutex<Told>,
}

#[derive(Default)]
struct Told {
    clients: HashMap<u32, Client>,
    stations: u32,
    events: VecDeque<EventView>,
    numbers: u64,
    alarms: Vec<AlarmView>,
    refused: Vec<RefusedView>,
    work: Option<Arc<WorkView>>,
    work_text: Option<Text>,
    machine: Option<Arc<Machine>>,
    /// Machine and process values that the devices serve.
    lines: Vec<(String, Traffic)>,
    /// Number of the cell's process.
    cell_process: Option<u32>,
    around: Option<Arc<Around>>,
    control: Option<Holder>,
    teach: TeachView,
}

struct Client {
    user: String,
    /// Its role may only watch and stop.
    watches: bool,
    to: mpsc::Sender<Text>,
}

struct Holder {
    station: u32,
    beat: Instant,
    /// End of the time during which the token stays with it: it jogs, or jogged a moment ago.
    jogs_until: Instant,
}

#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Control {
    pub(crate) station: u32,
    pub(crate) user: String,
}

/// Reason for refusing the token.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Refusal {
    /// Another station holds it.
    Held(Control),
    /// Its holder is jogging.
    Jogs,
}

fn text(message: &FromCell) -> Text {
    // Plain data with text keys: serialising cannot fail.
    serde_json::to_string(message).unwrap_or_default().into()
}

impl Hub {
    /// Locks the shared state, which stays consistent even if a thread panicked.
    fn lock(&self) -> MutexGuard<'_, Told> {
        self.told.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Connects a client. `None`: too many, in total or of its kind.
    pub(crate) fn connect(&self, user: &str, role: Role) -> Option<Connected> {
        let mut told = self.lock();
        let watches = role < Role::Operator;
        if !told.has_place(user, watches) {
            return None;
        }
        told.stations += 1;
        let station = told.stations;
        let (to, from) = mpsc::channel(MAX_WAITING_MESSAGES);
        let hello = FromCell::Hello { station, version: env!("CARGO_PKG_VERSION").to_owned() };
        let mut first = vec![text(&hello), text(&FromCell::Machine), text(&told.control(station))];
        // Reuses the serialised text: the program may be long.
        first.push(told.work_text.clone().unwrap_or_else(|| text(&FromCell::Work { work: None })));
        first.push(text(&told.alarms()));
        first.push(text(&FromCell::Commands { refused: told.refused.clone() }));
        first.push(text(&FromCell::Teach(told.teach.clone())));
        first.extend(told.events.iter().cloned().map(|event| text(&FromCell::Event(event))));
        for message in first {
            // The queue has room for all of them.
            drop(to.try_send(message));
        }
        told.clients.insert(station, Client { user: user.to_owned(), watches, to });
        Some((station, from, self.status.subscribe()))
    }

    /// Number of open pages.
    pub(crate) fn clients(&self) -> usize {
        self.lock().clients.len()
    }

    /// Disconnects a client; its control token becomes free.
    pub(crate) fn disconnect(&self, station: u32) {
        let mut told = self.lock();
        told.clients.remove(&station);
        if told.control.as_ref().is_some_and(|h| h.station == station) {
            told.give(None);
        }
    }

    /// Publishes the newest status, with the set-points of the axes, mm or rad.
    pub(crate) fn show(&self, mut status: Status, set: Joints) {
        status.near.clone_from(&self.near.lock().unwrap_or_else(PoisonError::into_inner));
        let message = text(&FromCell::Status(Box::new(status.clone())));
        *self.latest.lock().unwrap_or_else(PoisonError::into_inner) = Some((status, set));
        *self.shown.lock().unwrap_or_else(PoisonError::into_inner) = Some(Instant::now());
        self.status.send_replace(Some(message));
    }

    pub(crate) fn latest(&self) -> Option<Status> {
        self.latest.lock().unwrap_or_else(PoisonError::into_inner).as_ref().map(|(status, _)| status.clone())
    }

    /// Time since the last status of the cycle; `None` before the first one.
    pub(crate) fn age(&self) -> Option<Duration> {
        self.shown.lock().unwrap_or_else(PoisonError::into_inner).map(|shown| shown.elapsed())
    }

    pub(super) fn set_tally(&self, tally: Tally) {
        *self.tally.lock().unwrap_or_else(PoisonError::into_inner) = tally;
    }

    pub(crate) fn tally(&self) -> Tally {
        self.tally.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Counts a recorded weld.
    pub(super) fn count_weld(&self, result: WeldResult) {
        *self.welds.lock().unwrap_or_else(PoisonError::into_inner).entry(result.name()).or_default() += 1;
    }

    /// Number of recorded welds since the start, by result.
    pub(crate) fn welds(&self) -> Vec<CountView> {
        use WeldResult::{Deviating, Good, Interrupted, Stopped};
        let welds = self.welds.lock().unwrap_or_else(PoisonError::into_inner);
        let count = |result: WeldResult| welds.get(result.name()).copied().unwrap_or(0);
        let row = |result: WeldResult| CountView { name: result.name().to_owned(), count: count(result) };
        [Good, Deviating, Stopped, Interrupted].map(row).to_vec()
    }

    pub(crate) fn listed_alarms(&self) -> Vec<AlarmView> {
        self.lock().alarms.clone()
    }

    /// Set-points of the axes, mm or rad, if all axes are referenced.
    pub(crate) fn set_points(&self) -> Option<Joints> {
        let latest = self.latest.lock().unwrap_or_else(PoisonError::into_inner);
        let known = |status: &Status| status.axes.iter().all(|axis| axis.referenced);
        latest.as_ref().filter(|(status, _)| known(status)).map(|(_, set)| *set)
    }

    /// Newest status, with the set-points of the axes, mm or rad.
    pub(crate) fn standing(&self) -> Option<(Status, Joints)> {
        self.latest.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    pub(crate) fn event(&self, t: f64, happened: Happening) {
        happened.log();
        let mut told = self.lock();
        told.numbers += 1;
        let event = happened.view(told.numbers, t, written(Moment::now()));
        told.events.push_back(event.clone());
        if told.events.len() > RECENT_EVENTS {
            told.events.pop_front();
        }
        told.all(&FromCell::Event(event));
    }

    pub(crate) fn alarms(&self, list: Vec<AlarmView>) {
        let mut told = self.lock();
        told.alarms = list;
        let message = told.alarms();
        told.all(&message);
    }

    pub(super) fn refuses(&self, refused: Vec<RefusedView>) {
        let mut told = self.lock();
        told.refused.clone_from(&refused);
        told.all(&FromCell::Commands { refused });
    }

    pub(crate) fn teaches(&self, view: TeachView) {
        let mut told = self.lock();
        if told.teach != view {
            told.teach = view.clone();
            told.all(&FromCell::Teach(view));
        }
    }

    pub(crate) fn set_work(&self, work: Option<Arc<WorkView>>) {
        let message = text(&FromCell::Work { work: work.as_deref().cloned() });
        let mut told = self.lock();
        (told.work, told.work_text) = (work, Some(message.clone()));
        told.everybody(&message);
    }

    pub(crate) fn machine(&self) -> Option<Arc<Machine>> {
        self.lock().machine.clone()
    }

    pub(crate) fn set_machine(&self, machine: &Machine) {
        let mut told = self.lock();
        told.machine = Some(Arc::new(machine.clone()));
        told.all(&FromCell::Machine);
    }

    /// Traffic with each real device, by name.
    pub(crate) fn lines(&self) -> Vec<(String, Traffic)> {
        self.lock().lines.clone()
    }

    pub(super) fn set_cell_process(&self, process: u32) {
        self.lock().cell_process = Some(process);
    }

    /// Number of the cell's process, once it has answered.
    pub(crate) fn cell_process(&self) -> Option<u32> {
        self.lock().cell_process
    }

    pub(super) fn set_lines(&self, lines: Vec<(String, Traffic)>) {
        self.lock().lines = lines;
    }

    /// Sets the surroundings that the machine must keep clear of.
    pub(crate) fn set_around(&self, around: Arc<Around>) {
        self.lock().around = Some(around);
        self.set_near(None);
    }

    pub(crate) fn around(&self) -> Option<Arc<Around>> {
        self.lock().around.clone()
    }

    pub(super) fn set_near(&self, near: Option<NearView>) {
        *self.near.lock().unwrap_or_else(PoisonError::into_inner) = near;
    }

    pub(crate) fn work(&self) -> Option<Arc<WorkView>> {
        self.lock().work.clone()
    }

    pub(crate) fn tell(&self, station: u32, message: &FromCell) {
        self.lock().one(station, text(message));
    }

    pub(crate) fn user(&self, station: u32) -> Option<String> {
        self.lock().clients.get(&station).map(|c| c.user.clone())
    }

    pub(crate) fn holder(&self) -> Option<String> {
        let told = self.lock();
        told.control.as_ref().and_then(|h| told.clients.get(&h.station)).map(|c| c.user.clone())
    }

    /// Returns the holder of the control token if it is not `user`, or not the page `page` of that user. A script
    /// without a page is known by its user only.
    pub(crate) fn held_by_other(&self, user: &str, page: &str) -> Option<Control> {
        let told = self.lock();
        let held = told.control.as_ref()?;
        let by = Control { station: held.station, user: told.clients.get(&held.station)?.user.clone() };
        let is_own = by.user == user && (page.is_empty() || page == by.station.to_string());
        (!is_own).then_some(by)
    }

    pub(crate) fn beat(&self, station: u32) {
        if let Some(holder) = self.lock().control.as_mut().filter(|h| h.station == station) {
            holder.beat = Instant::now();
        }
    }

    /// Returns true if this station may command; `jogs`: it moves axes by hand.
    pub(crate) fn controls(&self, station: u32, jogs: bool) -> bool {
        let mut told = self.lock();
        let Some(holder) = told.control.as_mut().filter(|h| h.station == station) else { return false };
        if jogs {
            holder.jogs_until = Instant::now() + Duration::from_millis(300);
        }
        true
    }

    /// Gives the control token to `station`.
    pub(crate) fn take_control(&self, station: u32, over: bool) -> Result<(), Refusal> {
        let mut told = self.lock();
        let now = Instant::now();
        if let Some(holder) = told.control.as_ref().filter(|h| h.station != station) {
            if holder.jogs_until > now {
                return Err(Refusal::Jogs);
            }
            if !over {
                let user = told.clients.get(&holder.station).map_or(String::new(), |c| c.user.clone());
                return Err(Refusal::Held(Control { station: holder.station, user }));
            }
        }
        // A holder who takes it again keeps jogging.
        let jogs_until = told.control.as_ref().filter(|h| h.station == station).map_or(now, |h| h.jogs_until);
        told.give(Some(Holder { station, beat: now, jogs_until }));
        Ok(())
    }

    pub(crate) fn give_control(&self, station: u32) {
        let mut told = self.lock();
        if told.control.as_ref().is_some_and(|h| h.station == station) {
            told.give(None);
        }
    }

    /// Takes the token from a silent holder. Returns true if it was lost.
    pub(crate) fn forget_silent(&self) -> bool {
        let mut told = self.lock();
        let silent = told.control.as_ref().is_some_and(|h| h.beat.elapsed() > BEAT);
        if silent {
            told.give(None);
        }
        silent
    }
}

impl Told {
    /// Returns true if `user` may open one more page. The last places are reserved for operators without a page.
    fn has_place(&self, user: &str, watches: bool) -> bool {
        let all = self.clients.len();
        let own = self.clients.values().filter(|c| c.user == user).count();
        let watching = self.clients.values().filter(|c| c.watches).count();
        match (watches, own) {
            (true, _) => {
                all < MAX_PAGES - PAGES_KEPT_FOR_OPERATORS && watching < MAX_VIEWER_PAGES && own < MAX_PAGES_OF_USER
            }
            (false, 0) => all < MAX_PAGES,
            (false, _) => all < MAX_PAGES - PAGES_KEPT_FOR_OPERATORS && own < MAX_PAGES_OF_USER,
        }
    }

    fn all(&mut self, message: &FromCell) {
        self.everybody(&text(message));
    }

    fn everybody(&mut self, message: &Text) {
        let stations: Vec<u32> = self.clients.keys().copied().collect();
        for station in stations {
            self.one(station, message.clone());
        }
    }

    /// Sends a message, or disconnects a client that does not read: it must not miss any.
    fn one(&mut self, station: u32, message: Text) {
        if self.clients.get(&station).is_some_and(|c| c.to.try_send(message).is_err()) {
            self.clients.remove(&station);
            if self.control.as_ref().is_some_and(|h| h.station == station) {
                self.give(None);
            }
        }
    }

    fn give(&mut self, holder: Option<Holder>) {
        self.control = holder;
        let stations: Vec<u32> = self.clients.keys().copied().collect();
        for station in stations {
            let message = text(&self.control(station));
            self.one(station, message);
        }
    }

    fn control(&self, to: u32) -> FromCell {
        let station = self.control.as_ref().map(|h| h.station);
        let user = station.and_then(|s| self.clients.get(&s)).map(|c| c.user.clone());
        FromCell::Control { station, user, mine: station == Some(to) }
    }

    fn alarms(&self) -> FromCell {
        FromCell::Alarms { list: self.alarms.clone() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::event::happening;
    use seamwright_message::Message;

    /// An operator always gets one page, and further pages do not take the places of other operators.
    #[test]
    fn places_are_kept_for_those_who_operate() {
        let hub = Hub::default();
        let open = |user: &str, role: Role| -> Vec<Connected> {
            std::iter::from_fn(|| hub.connect(user, role)).take(2 * MAX_PAGES).collect()
        };
        let watching: Vec<Connected> = (0..8).flat_map(|i| open(&format!("viewer {i}"), Role::Viewer)).collect();
        assert_eq!(watching.len(), MAX_VIEWER_PAGES);
        let operating: Vec<Connected> = (0..1).flat_map(|i| open(&format!("service {i}"), Role::Service)).collect();
        assert_eq!(operating.len(), MAX_PAGES - PAGES_KEPT_FOR_OPERATORS - MAX_VIEWER_PAGES);
        for i in 0..PAGES_KEPT_FOR_OPERATORS {
            assert_eq!(open(&format!("operator {i}"), Role::Operator).len(), 1, "{i}");
        }
        assert!(hub.connect("one more", Role::Operator).is_none());
        hub.disconnect(watching[0].0);
        assert!(hub.connect("one more", Role::Operator).is_some());
    }

    #[test]
    fn clients_that_do_not_listen_go() {
        let hub = Hub::default();
        let others: Vec<Connected> =
            (0..8).map(|i| hub.connect(&format!("user {i}"), Role::Operator).unwrap()).collect();
        // The token is lost with the disconnected client.
        hub.take_control(others[0].0, false).unwrap();
        (0..2 * MAX_WAITING_MESSAGES)
            .for_each(|i| hub.event(0.0, happening(Message::new("server-event-order").text("order", format!("{i}")))));
        assert!(hub.clients() == 0 && hub.holder().is_none());
    }

    /// The token cannot be taken while its holder jogs, even after the holder took it again.
    #[test]
    fn the_token_stays_with_a_hand_that_moves() {
        let hub = Hub::default();
        let (ada, eve) = (hub.connect("ada", Role::Operator).unwrap(), hub.connect("eve", Role::Operator).unwrap());
        hub.take_control(ada.0, false).unwrap();
        assert!(hub.controls(ada.0, true) && !hub.controls(eve.0, true));
        hub.take_control(ada.0, true).unwrap();
        assert_eq!(hub.take_control(eve.0, true), Err(Refusal::Jogs));
        std::thread::sleep(Duration::from_millis(320));
        assert!(matches!(hub.take_control(eve.0, false), Err(Refusal::Held(_))));
        hub.take_control(eve.0, true).unwrap();
        assert!(!hub.controls(ada.0, false) && hub.controls(eve.0, false));
    }
}
