// SPDX-License-Identifier: MIT
//
// The only entry: puts the viewer of the page's snapshot into an element.

import { mount as mountComponent, unmount } from 'svelte';

import App from './App.svelte';
import { bytesFromBase64, gunzipped, readSnapshot, SnapshotError } from './snapshot';
import type { Snapshot } from './types';

async function pageSnapshot(): Promise<Snapshot> {
  // One element does not hold more than half a gigabyte of text: there may be several.
  const elements = document.querySelectorAll('script[type="application/gzip"]');
  const parts = [...elements].map((element) => element.textContent.trim()).filter(Boolean);
  if (parts.length === 0 || parts[0].startsWith('%')) {
    throw new SnapshotError('missing', 'There is no data in this page.');
  }
  return readSnapshot(await gunzipped(bytesFromBase64(parts)));
}

/** What to say of something that kept the viewer from starting. */
function explained(error: unknown): { title: string; text: string; reason: string } {
  if (error instanceof SnapshotError) {
    return {
      title: error.message,
      text: 'Make the page again with “orthoball view FILE”, or get another copy of it.',
      reason: error.reason,
    };
  }
  if (error instanceof RangeError) {
    return {
      title: 'The data is too large for this browser.',
      text: 'Close other pages, or use a computer with more memory. The command line has no such limit: “orthoball shape”, “orthoball signatures”.',
      reason: 'too_large',
    };
  }
  return { title: 'The viewer could not start.', text: String(error), reason: 'failed' };
}

function showMessage(host: HTMLElement, error: unknown): void {
  const { title, text, reason } = explained(error);
  const box = document.createElement('div');
  box.className = 'message';
  box.setAttribute('role', 'alert');
  const [heading, paragraph] = [document.createElement('h1'), document.createElement('p')];
  heading.textContent = title;
  paragraph.textContent = text;
  box.append(heading, paragraph);
  host.replaceChildren(box);
  host.dataset.error = reason;
}

/** Shows the page's snapshot in `host`, or a message that says why it cannot be shown. */
export async function mount(host: HTMLElement): Promise<{ dispose: () => void }> {
  try {
    const snapshot = await pageSnapshot();
    host.replaceChildren();
    const app = mountComponent(App, { target: host, props: { snapshot, host } });
    return { dispose: () => void unmount(app) };
  } catch (error) {
    showMessage(host, error);
    return { dispose: () => host.replaceChildren() };
  }
}
