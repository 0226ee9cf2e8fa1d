// SPDX-License-Identifier: MIT
import { mount } from './mount';

const host = document.getElementById('viewer');
if (host) {
  void mount(host).then(({ dispose }) => {
    // For pages that embed the viewer.
    host.addEventListener('orthoball-dispose', dispose, { once: true });
  });
}
