// SPDX-License-Identifier: MIT
// Debian's Chromium without a display, drawing in software.
import { createRequire } from 'node:module';

const require = createRequire(new URL('../viewer/package.json', import.meta.url));
const { chromium } = require('playwright-core');

/** A browser of playwright-core; to be closed. CHROMIUM names another program. */
export function launched() {
  return chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: [
      '--no-sandbox',
      '--use-angle=swiftshader',
      '--enable-unsafe-swiftshader',
      '--disable-background-networking',
    ],
  });
}
