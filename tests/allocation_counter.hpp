// Counts allocations of the whole program, between start and stop: what Catch and other tests do is none of
// our business.
#pragma once

namespace allocation_counter {

/// Whether allocations can be counted here: not with another C library, nor under a sanitizer.
bool available();
/// Goes on counting from where it stopped.
void start();
void stop();
long count();
void reset();

}  // namespace allocation_counter
