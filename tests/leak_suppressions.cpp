// fontconfig 2.14 loses 288 bytes while it reads its own configuration, once per process.
// SPDX-License-Identifier: GPL-3.0-or-later

extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig.so\n"; }

/// Suppressed leaks are not reported: tests read what the programs say on standard error.
extern "C" const char* __lsan_default_options();
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
