/** Controls and robots that part programs are written for, with the endings of their files. */
export const CONTROLS = [
  ['sinumerik', 'Sinumerik', '.mpf'],
  ['linuxcnc', 'LinuxCNC', '.ngc'],
  ['grblhal', 'grblHAL', '.ngc'],
  ['pmac', 'PMAC', '.pmc'],
  ['rapid', 'ABB RAPID', '.mod'],
  ['krl', 'KUKA KRL', '.src'],
  ['fanuc-ls', 'FANUC LS', '.ls'],
  ['urscript', 'URScript', '.script'],
  ['inform', 'Yaskawa INFORM', '.jbi'],
] as const;
