#pragma once

#include <stddef.h> /* NOLINT(modernize-deprecated-headers): for C */

#ifdef __cplusplus
extern "C" {
#endif

/* Writes a log of 3 steps of "C engine 0.1": a cube falls, another is thrown in before step 2. Returns the last call's
 * status and the message of the first call that failed. */
int write_log_in_c(const char* path, char* message, size_t room);

/* Ends a step of a log that was never begun. */
int misuse_log_in_c(char* message, size_t room);

/* Declares a channel of any kind and scope, which C++ could not pass. */
int add_channel_in_c(int kind, int scope, char* message, size_t room);

#ifdef __cplusplus
}
#endif
