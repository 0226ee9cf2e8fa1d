// SPDX-License-Identifier: MIT
import { mount } from './mount';

const host = document.getElementById('viewer');
if (host) void mount(host);
