const KEPT = 'seamwright.dark';

/** Light or dark: as the browser says, until somebody chooses. */
class Theme {
  dark = $state((localStorage.getItem(KEPT) ?? String(matchMedia('(prefers-color-scheme: dark)').matches)) === 'true');

  constructor() {
    this.show();
  }

  turn(): void {
    this.dark = !this.dark;
    localStorage.setItem(KEPT, String(this.dark));
    this.show();
  }

  private show(): void {
    document.documentElement.classList.toggle('dark', this.dark);
  }
}

export const theme = new Theme();

/** The value of a colour of app.css, for what draws by itself. */
export function colour(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}
