// SPDX-License-Identifier: MIT
//
// Starts Chromium once for all files of tests.

import { chromium } from 'playwright-core';
import type { TestProject } from 'vitest/node';

declare module 'vitest' {
  export interface ProvidedContext {
    /** Where it listens. */
    chromium: string;
  }
}

export default async function start({ provide }: TestProject): Promise<() => Promise<void>> {
  const server = await chromium.launchServer({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: [
      '--no-sandbox',
      '--use-angle=swiftshader',
      '--enable-unsafe-swiftshader',
      '--disable-background-networking',
    ],
  });
  provide('chromium', server.wsEndpoint());
  return () => server.close();
}
