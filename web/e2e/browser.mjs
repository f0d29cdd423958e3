// The browser of the tests.
import { existsSync, readFileSync } from 'node:fs';
import { extname, join } from 'node:path';
import { chromium } from 'playwright-core';

const CHROMIUM = process.env.SEAMWRIGHT_CHROMIUM ?? '/usr/bin/chromium';

export const SIZES = {
  touch: { width: 1280, height: 800 },
  desktop: { width: 1920, height: 1080 },
  phone: { width: 390, height: 844 },
};

/** A folder with a built panel, which is shown instead of the one inside the program: to try a panel without building that. */
const panel = process.env.SEAMWRIGHT_PANEL;
const KINDS = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.svg': 'image/svg+xml' };

/** WebGL by software: the same everywhere, but it takes a processor for itself. Without it the panel shows all but its scenes. */
const BY_SOFTWARE = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];

/** Starts the browser, with scenes only for tests that look at them. */
export async function launch({ scenes = false } = {}) {
  const browser = await chromium.launch({
    executablePath: CHROMIUM,
    args: [
      '--no-sandbox',
      '--disable-quic',
      '--no-first-run',
      '--disable-background-networking',
      '--disable-component-update',
      '--disable-sync',
      ...(scenes ? BY_SOFTWARE : ['--disable-3d-apis']),
      '--disable-gpu-compositing',
      // What a test fulfils by itself has no address, so Chromium takes the cell for another network's.
      ...(panel ? ['--disable-features=LocalNetworkAccessChecks'] : []),
    ],
  });
  return Object.assign(browser, { scenes });
}

function fromFolder(route) {
  const { pathname } = new URL(route.request().url());
  const file = join(panel, pathname === '/' ? 'index.html' : pathname);
  if (!existsSync(file)) return route.fulfill({ status: 404 });
  const headers = { 'content-type': KINDS[extname(file)] ?? 'text/plain', 'content-security-policy': "default-src 'self'" };
  return route.fulfill({ status: 200, headers, body: readFileSync(file) });
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
  if (panel) await context.route((url) => !url.pathname.startsWith('/api/'), fromFolder);
  const made = await context.newPage();
  made.setDefaultTimeout(20_000);
  made.wrong = [];
  made.on('console', (message) => {
    if (message.type() === 'error' || message.type() === 'warning') made.wrong.push(`${message.text()} ${message.location().url}`);
  });
  made.on('pageerror', (error) => made.wrong.push(String(error)));
  return made;
}
