// Leaks of libraries that are not ours: fontconfig 2.14 loses 288 bytes while it reads its own configuration, once per
// process, and the D-Bus library that SDL opens keeps its connection.
// SPDX-License-Identifier: GPL-3.0-or-later

extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libfontconfig.so\n"
           "leak:libdbus-1.so\n";
}

/// Suppressed leaks are not reported: tests read what the programs say on standard error.
extern "C" const char* __lsan_default_options();
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }

/// Drivers are never unloaded: what only their own variables point to would look lost, in a module without a name.
extern "C" int dlclose(void*);
extern "C" int dlclose(void*) { return 0; }
