import { api, Refusal, useToken } from './api';
import type { SessionView } from '../wire';

/** Who is logged in. `undefined`: not known yet. */
class Session {
  view = $state.raw<SessionView | null | undefined>(undefined);

  /** It was ended by the cell, not here. */
  over = $state(false);

  /** Who was just made the first administrator, and has to log in now. */
  made = $state('');

  /** Asks the server; with the key of the printed address (`#key=`) it logs in with that first. */
  async begin(): Promise<void> {
    const key = /^#key=(.+)$/.exec(location.hash)?.[1];
    if (key) {
      // The key is a secret: not to be left in the address line or in the history.
      history.replaceState(null, '', location.pathname);
      useToken('login');
      try {
        this.take(await api.login({ user: '', password: decodeURIComponent(key) }));
        return;
      } catch {
        // Used up or wrong: perhaps there is a session all the same.
      }
    }
    await this.ask();
  }

  async ask(): Promise<void> {
    try {
      this.take(await api.session());
    } catch (error) {
      if (error instanceof Refusal && error.status === 401) {
        if (this.view) this.over = true;
        this.view = null;
      }
      else if (this.view === undefined) this.view = null;
    }
  }

  async login(user: string, password: string): Promise<void> {
    useToken('login');
    this.take(await api.login({ user, password }));
  }

  async logout(): Promise<void> {
    await api.logout().catch(() => undefined);
    this.over = false;
    this.view = null;
  }

  may(permission: string): boolean {
    return this.view?.may.includes(permission) ?? false;
  }

  private take(view: SessionView): void {
    useToken(view.token);
    this.over = false;
    this.made = '';
    this.view = view;
  }
}

export const session = new Session();
