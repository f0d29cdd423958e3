// The browser of the tests. Software WebGL: slow, but the same everywhere.
import { existsSync } from 'node:fs';
import { chromium } from 'playwright-core';

export const CHROMIUM = process.env.SEAMWRIGHT_CHROMIUM ?? '/usr/bin/chromium';
export const hasBrowser = existsSync(CHROMIUM);

export const SIZES = {
  touch: { width: 1280, height: 800 },
  desktop: { width: 1920, height: 1080 },
  phone: { width: 390, height: 844 },
};

export function launch() {
  return chromium.launch({
    executablePath: CHROMIUM,
    args: [
      '--no-sandbox',
      '--disable-quic',
      '--no-first-run',
      '--disable-background-networking',
      '--disable-component-update',
      '--disable-sync',
      '--use-gl=angle',
      '--use-angle=swiftshader',
      '--enable-unsafe-swiftshader',
      '--disable-gpu-compositing',
    ],
  });
}

/** A page in its own context that collects what goes wrong in it. */
export async function page(browser, { size = 'touch', language = 'en', dark = false, toured = true } = {}) {
  const context = await browser.newContext({ viewport: SIZES[size], locale: language, colorScheme: dark ? 'dark' : 'light' });
  await context.addInitScript(
    ([code, done]) => {
      localStorage.setItem('seamwright.language', code);
      if (done) localStorage.setItem('seamwright.toured', 'true');
    },
    [language, toured],
  );
  const made = await context.newPage();
  made.wrong = [];
  made.on('console', (message) => {
    if (message.type() === 'error' || message.type() === 'warning') made.wrong.push(message.text());
  });
  made.on('pageerror', (error) => made.wrong.push(String(error)));
  return made;
}
