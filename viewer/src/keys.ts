// SPDX-License-Identifier: MIT

/** Whether what has the focus takes a key for itself, or the browser does. */
export function isTaken(event: KeyboardEvent): boolean {
  const own =
    event.key === 'Escape' ? 'dialog' : 'select, textarea, dialog, input:not([type="checkbox"])';
  return (
    (event.target as HTMLElement).closest(own) !== null ||
    event.ctrlKey ||
    event.metaKey ||
    event.altKey
  );
}
