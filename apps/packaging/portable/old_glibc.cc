// What Debian 12's libstdc++.a and headers take from glibc 2.32 and 2.36, for a program that starts with glibc 2.29,
// too. portable.sh links it.
#include <sys/random.h>

#include <cstdlib>

extern "C" {

/// Whether the process has one thread only, so that counters needn't be atomic. Never set here: they always are.
char __libc_single_threaded = 0;

/// Of std::random_device.
unsigned arc4random();
unsigned arc4random() {
  unsigned number = 0;
  if (getentropy(&number, sizeof number) != 0) std::abort();
  return number;
}
}
