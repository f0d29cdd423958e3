import { alarmTitle, named, t, words, type Key } from './index.svelte';
import { matcher, ofRow, type Row } from './patterns';
import { ofWelds } from './sentences';

/** What the audit log says that nothing else does. It is kept in English, as evidence; a test holds this against its sources, as those of plans. */
const ROWS: readonly Row[] = [
  // Where from.
  ['panel', 'панель', '面板', 'Panel', 'панель'],
  ['panel {0=}', 'панель {0}', '面板 {0}', 'Panel {0}', 'панель {0}'],
  ['panel at {0=}', 'панель на {0}', '{0} 上的面板', 'Panel auf {0}', 'панель на {0}'],
  ['command line', 'командний рядок', '命令行', 'Befehlszeile', 'командная строка'],
  // What.
  ['save job {0=}', 'зберегти завдання {0}', '保存任务 {0}', 'Auftrag {0} speichern', 'сохранить задание {0}'],
  ['delete job {0=}', 'видалити завдання {0}', '删除任务 {0}', 'Auftrag {0} löschen', 'удалить задание {0}'],
  ['load {0=}', 'завантажити {0}', '装入 {0}', '{0} laden', 'загрузить {0}'],
  ['change user {0=}', 'змінити користувача {0}', '更改用户 {0}', 'Benutzer {0} ändern', 'изменить пользователя {0}'],
  ['delete user {0=}', 'видалити користувача {0}', '删除用户 {0}', 'Benutzer {0} löschen', 'удалить пользователя {0}'],
  ['set {0} {1=} in {2=}', 'змінити {0} {1} у {2}', '更改{0} {1}（{2}）', '{0} {1} in {2} ändern', 'изменить {0} {1} в {2}'],
  ['axis', 'вісь', '轴', 'Achse', 'ось'],
  ['tool', 'інструмент', '工具', 'Werkzeug', 'инструмент'],
  ['sensor', 'давач', '传感器', 'Sensor', 'датчик'],
  ['acknowledge {0}', 'підтвердити: {0}', '确认：{0}', 'quittieren: {0}', 'подтвердить: {0}'],
  ['shelve alarm {0} {1} for {2} min', 'відкласти тривогу {0} {1} на {2} хв', '搁置报警 {0} {1}，{2} 分钟', 'Alarm {0} {1} für {2} min zurückstellen', 'отложить тревогу {0} {1} на {2} мин'],
  ['check archive', 'перевірити копію', '检查备份', 'Sicherung prüfen', 'проверить копию'],
  ['what is finished may be welded again', 'завершене можна варити знову', '已完成的部分可再次焊接', 'Fertiges darf wieder geschweißt werden', 'завершённое можно варить снова'],
  ['quit', 'завершити', '退出', 'beenden', 'завершить'],
  ['watch', 'дивитися', '查看', 'zuschauen', 'смотреть'],
  ['plan', 'планувати', '规划', 'planen', 'планировать'],
  ['weld {0}', 'зварювання {0}', '焊接 {0}', 'Schweißung {0}', 'сварка {0}'],
  ['weld {0} of part {1=}', 'зварювання {0}, виріб {1}', '焊接 {0}，工件 {1}', 'Schweißung {0}, Werkstück {1}', 'сварка {0}, изделие {1}'],
  ['teach: {0}', 'навчання: {0}', '示教：{0}', 'Teachen: {0}', 'обучение: {0}'],
  ['Open: step {0} mm, tacks up to {1} mm, seed {2}', 'увімкнути камеру: крок {0} мм, прихватки до {1} мм, зерно {2}', '打开视觉：步长 {0} mm，定位焊不超过 {1} mm，种子 {2}', 'Kamera öffnen: Schritt {0} mm, Heftstellen bis {1} mm, Startwert {2}', 'включить камеру: шаг {0} мм, прихватки до {1} мм, зерно {2}'],
  ['{0}|, a tack from {1} to {2} mm', '{0}, прихватка від {1} до {2} мм', '{0}，定位焊从 {1} 到 {2} mm', '{0}, eine Heftstelle von {1} bis {2} mm', '{0}, прихватка от {1} до {2} мм'],
  ['Here: pixel {0}, {1}', 'стик тут: піксель {0}, {1}', '接缝在这里：像素 {0}, {1}', 'Fuge ist hier: Pixel {0}, {1}', 'стык здесь: пиксель {0}, {1}'],
  ['Here: X {0} Y {1} Z {2} mm', 'стик тут: X {0} Y {1} Z {2} мм', '接缝在这里：X {0} Y {1} Z {2} mm', 'Fuge ist hier: X {0} Y {1} Z {2} mm', 'стык здесь: X {0} Y {1} Z {2} мм'],
  ['Here: where the eye looks', 'стик там, куди дивиться камера', '接缝在视觉所看之处', 'Fuge ist, wo die Kamera hinsieht', 'стык там, куда смотрит камера'],
  // What came of it.
  ['taken', 'прийнято', '已接受', 'angenommen', 'принято'],
  ['saved', 'збережено', '已保存', 'gespeichert', 'сохранено'],
  ['deleted', 'видалено', '已删除', 'gelöscht', 'удалено'],
  ['changed', 'змінено', '已更改', 'geändert', 'изменено'],
  ['kept', 'збережено', '已保留', 'gespeichert', 'сохранено'],
  ['begun', 'почато', '已开始', 'begonnen', 'начато'],
  ['checked', 'перевірено', '已检查', 'geprüft', 'проверено'],
  ['logged in', 'вхід виконано', '已登录', 'angemeldet', 'вход выполнен'],
  ['logged out', 'вихід виконано', '已登出', 'abgemeldet', 'выход выполнен'],
  ['refused', 'відмовлено', '已拒绝', 'abgelehnt', 'отказано'],
  ['refused: role', 'відмовлено: роль не дозволяє', '已拒绝：角色不允许', 'abgelehnt: Rolle erlaubt es nicht', 'отказано: роль не позволяет'],
  ['{0}: {1} more in {2} s', '{0}: ще {1} за {2} с', '{0}：{2} s 内又有 {1} 次', '{0}: {1} weitere in {2} s', '{0}: ещё {1} за {2} с'],
  ['others', 'інші', '其他', 'weitere', 'прочие'],
  ['restored; what was there before is in {0=}', 'відновлено; те, що було, лежить у {0}', '已恢复；原有数据在 {0}', 'wiederhergestellt; was vorher da war, liegt in {0}', 'восстановлено; то, что было, лежит в {0}'],
  ['{0} entries were left out', 'пропущено записів: {0}', '漏记 {0} 条', '{0} Einträge wurden ausgelassen', 'пропущено записей: {0}'],
  ['{0} rows', 'рядків: {0}', '{0} 行', '{0} Zeilen', 'строк: {0}'],
  ['{0}|, disabled', '{0}, вхід закрито', '{0}，已停用', '{0}, gesperrt', '{0}, вход закрыт'],
  // Why not.
  ['axis {0=}', 'вісь {0}', '轴 {0}', 'Achse {0}', 'ось {0}'],
  ['there is no job `{0=}`', 'завдання «{0}» немає', '没有任务“{0}”', 'es gibt keinen Auftrag „{0}“', 'задания «{0}» нет'],
  ['{0} min; allowed: up to {1}', '{0} хв; дозволено: до {1}', '{0} 分钟；允许：最多 {1}', '{0} min; erlaubt: bis {1}', '{0} мин; разрешено: до {1}'],
  ['this alarm is not on the list; allowed: one that is', 'цієї тривоги немає в переліку', '该报警不在列表中', 'dieser Alarm steht nicht auf der Liste', 'этой тревоги нет в списке'],
  ['`{0}` does more than tell ({1}); allowed: alarms that only tell', '«{0}» не лише повідомляє ({1}); дозволено: тривоги, що лише повідомляють', '“{0}”不只是提示（{1}）；允许：只作提示的报警', '„{0}“ meldet nicht nur ({1}); erlaubt: Alarme, die nur melden', '«{0}» не только сообщает ({1}); разрешено: тревоги, которые только сообщают'],
  ['a session is open: stop it first', 'сеанс уже відкрито: спершу зупиніть його', '会话已打开：请先停止', 'eine Sitzung ist offen: zuerst beenden', 'сеанс уже открыт: сначала остановите его'],
  ['no session is open', 'сеанс не відкрито', '没有打开的会话', 'keine Sitzung ist offen', 'сеанс не открыт'],
  ['nobody asks where the joint is', 'ніхто не питає, де стик', '没有询问接缝位置', 'niemand fragt, wo die Fuge ist', 'никто не спрашивает, где стык'],
  ['nothing is paused', 'нічого не призупинено', '没有什么在暂停', 'nichts ist angehalten', 'ничего не приостановлено'],
  ['there is no work in the picture there', 'там на зображенні немає деталі', '图像该处没有工件', 'dort ist im Bild kein Werkstück', 'там на изображении нет детали'],
  ['the place is not near the nominal seam; allowed: within 15 mm of it', 'місце не біля номінального шва; дозволено: до 15 мм від нього', '该位置不在名义焊缝附近；允许：15 mm 以内', 'die Stelle liegt nicht an der Sollnaht; erlaubt: bis 15 mm davon', 'место не у номинального шва; разрешено: до 15 мм от него'],
  ['the machine\'s devices are real, and its file names no camera\'s `frames`: teach by jogging', 'пристрої верстата справжні, камери там немає: навчайте вручну', '机床设备是真实的，面板在那里没有视觉：请点动示教', 'die Geräte der Maschine sind echt, dort hat das Panel keine Kamera: von Hand teachen', 'устройства станка настоящие, камеры там нет: обучайте вручную'],
  ['the archive broke off on its way', 'копія обірвалася в дорозі', '备份在传输中断开', 'die Sicherung brach unterwegs ab', 'копия оборвалась в пути'],
  ['nobody in it can administer: nobody could use the panel after it', 'у копії немає адміністратора: панеллю ніхто не зміг би користуватися', '备份中没有管理员：之后无人能使用面板', 'niemand darin kann verwalten: danach könnte niemand das Panel benutzen', 'в копии нет администратора: панелью никто не смог бы пользоваться'],
];

/** What the panel has words for anyhow: the English, the key, and what stands in its holes. */
const KEYS: readonly (readonly [en: string, key: Key, ...of: string[]])[] = [
  ['take control', 'control.take'],
  ['take_control', 'control.take'],
  ['control taken', 'said.control_taken'],
  ['control taken over', 'said.control_taken_over'],
  ['log in', 'login.go'],
  ['log out', 'login.out'],
  ['own password', 'user.own_password'],
  ['backup', 'setup.data'],
  ['restore', 'data.restore'],
  ['audit', 'setup.audit'],
  ['loaded', 'job.loaded'],
  ['load', 'job.load'],
  ['edit', 'job.edit'],
  ['post', 'job.post'],
  ['tune', 'setup.tuning'],
  ['set_up', 'tab.setup'],
  ['shelve', 'alarm.shelve'],
  ['jog', 'mode.jog'],
  ['teach', 'mode.teach'],
  ['jobs.read', 'tab.jobs'],
  ['jobs.write', 'tab.jobs'],
  ['records.read', 'tab.records'],
  ['audit.read', 'setup.audit'],
  ['users.read', 'setup.users'],
  ['users.write', 'setup.users'],
  ['End', 'teach.end_here'],
  ['Pause', 'teach.pause'],
  ['Resume', 'teach.resume'],
  ['Stop', 'teach.stop'],
  ['`{0}` has no meaning in mode {1}: allowed in| {2}', 'lack.mode', '{2}'],
  ['the axes have not come to rest: wait a moment', 'lack.moving'],
  ['the reference of {0=} is not known: home first', 'lack.references', '{0}'],
  ['axis {0=} goes home first: so says the machine file', 'lack.homes_first', '{0}'],
  ['the drives have no power yet: wait a moment', 'lack.power'],
  ['the {0} cannot be heard: check cable and device', 'lack.silent', '{0}'],
  ['`{0}` is not met', 'lack.condition', '{0}'],
  ['alarm `{0}`{1}: {2}, then acknowledge', 'lack.alarm', '{0}{1}'],
  ['the process is not armed: arm, then start within a minute', 'lack.arming'],
  ['the process source is not ready', 'lack.source'],
  ['axis {0=} is not where the way to the weld begins', 'lack.not_at_start', '{0}'],
  ['no program is loaded', 'lack.work'],
  ['no program is loaded: its seam says where the joint is nominally', 'lack.work'],
  ['the number is outside what is allowed', 'lack.value'],
  ['the motion cannot do that now', 'lack.motion'],
  ['this page does not have control: take it first', 'control.needed'],
  ['command {0} came before; allowed: greater than {1}', 'lack.replayed'],
  ['allowed: archives of up to {0} MiB; `seamwright records restore` takes larger ones', 'trouble.size'],
];

/** For the test. */
export const rows = { said: ROWS, keys: KEYS };

const sentence = matcher([...[...ROWS, ...ofWelds].map(ofRow), ...KEYS.map(([en, key, ...of]) => [en, () => t(key, ...of)] as const)]);

/** Names of orders, modes, results, roles, reactions, devices, conditions and alarms in the words of the panel. */
function word(text: string): string {
  // What an alarm is about.
  const about = /^ \((.*)\)$/.exec(text);
  if (about) return ` (${audited(about[1] ?? '')})`;
  const modes = text.split(', ').map((mode) => [mode, named('mode', mode)] as const);
  if (modes.every(([mode, words]) => mode !== words)) return modes.map(([, words]) => words).join(', ');
  for (const [kind, name] of [['do', text], ['result', text], ['role', text.toLowerCase()], ['reaction', text.replaceAll(',', '')], ['device', text], ['interlock', text]] as const) {
    const words = named(kind, name);
    if (words !== name) return words;
  }
  return alarmTitle(text);
}

/** An entry of the audit log in the chosen language; what has no words here stays as it was written. */
export function audited(text: string): string {
  return sentence(text, words.language, word);
}
