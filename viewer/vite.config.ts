// SPDX-License-Identifier: MIT
//
// Builds one HTML page that holds everything, with places for a title and for the data.

import { svelte } from '@sveltejs/vite-plugin-svelte';
import type { Plugin } from 'vite';
import { defineConfig } from 'vitest/config';

/** Puts the script and the style sheet into the page. */
function inlined(): Plugin {
  return {
    name: 'inlined',
    enforce: 'post',
    generateBundle(_, bundle) {
      const page = Object.values(bundle).find((file) => file.fileName === 'index.html');
      if (page?.type !== 'asset') throw new Error('there is no page');
      let html = String(page.source);
      for (const file of Object.values(bundle)) {
        if (file === page) continue;
        if (file.type === 'chunk') {
          // What the HTML parser would take for the end of the script, or for its own syntax.
          const code = file.code.replace(/<(\/script|!--)/g, '\\x3C$1');
          html = html.replace(/<script type="module"[^>]*src="[^"]*"[^>]*><\/script>/, '');
          html = html.replace('<!--script-->', () => `<script type="module">${code}</script>`);
        } else if (file.fileName.endsWith('.css')) {
          html = html.replace(
            /<link rel="stylesheet"[^>]*>/,
            () => `<style>${file.source}</style>`,
          );
        } else {
          throw new Error(`${file.fileName} does not go into the page`);
        }
        delete bundle[file.fileName];
      }
      page.source = html;
    },
  };
}

export default defineConfig({
  plugins: [svelte({ configFile: false }), inlined()],
  build: {
    target: 'es2022',
    assetsInlineLimit: 0,
    cssCodeSplit: false,
    modulePreload: false,
    emptyOutDir: true,
    chunkSizeWarningLimit: 1000,
  },
  test: {
    environment: 'node',
    projects: [
      {
        extends: true,
        test: { name: 'unit', include: ['tests/unit/*.test.ts'], testTimeout: 60_000 },
      },
      {
        extends: true,
        test: {
          name: 'browser',
          include: ['tests/browser/*.test.ts'],
          globalSetup: ['tests/browser/chromium.ts'],
          fileParallelism: false,
          testTimeout: 120_000,
          hookTimeout: 120_000,
        },
      },
    ],
  },
});
