// fontconfig 2.14 loses 288 bytes while it reads its own configuration, once per process.
// SPDX-License-Identifier: GPL-3.0-or-later

extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig.so\n"; }
