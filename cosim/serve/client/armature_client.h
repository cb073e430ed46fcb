/* Client of `armature serve`: registers, pins and simulated time of the logic from a C99 or C++ program.
 *
 * Header only, POSIX, no other dependency. The protocol is described in cosim/serve/README.md. Every function returns
 * ARMATURE_OK, ARMATURE_REFUSED when the server answered `error ...` (the text is in `error`; the connection stays
 * open), or ARMATURE_LOST when the connection or the protocol has failed (close it). Not for use by two threads at a
 * time.
 *
 * Over TCP the server requires the token that it printed when it started. armature_open() reads it from the environment
 * variable ARMATURE_TOKEN; armature_open_with_token() has an argument for it.
 *
 *   static armature_client soc;                       // about 70 KB, too large for a small stack
 *   uint32_t value;
 *   if (armature_open(&soc, "tcp:5025") == ARMATURE_OK && armature_read(&soc, 0x42800008, &value) == ARMATURE_OK) ...
 *   armature_close(&soc);
 *
 * Pipelining: armature_post() sends a command without waiting, armature_answer() returns the answers in the same order.
 * At most ARMATURE_MAX_IN_FLIGHT may be unanswered; all must be answered before a function that waits is called.
 *
 * Compiled with -std=c99 this must be the first header, or _POSIX_C_SOURCE must be defined as 200112L or more.
 */
#ifndef ARMATURE_CLIENT_H
#define ARMATURE_CLIENT_H

#ifndef _POSIX_C_SOURCE
#define _POSIX_C_SOURCE 200112L
#endif

#include <errno.h>
#include <inttypes.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { ARMATURE_OK = 0, ARMATURE_REFUSED = -1, ARMATURE_LOST = -2 };

enum {
  ARMATURE_MAX_IN_FLIGHT = 4096, /* commands that may be sent before an answer is read */
  ARMATURE_MAX_LINE = 4096,      /* of a command, its end not counted */
  ARMATURE_MAX_ANSWER = 512
};

typedef struct armature_client {
  int socket;
  size_t out_size, in_begin, in_end;
  unsigned in_flight;
  char error[ARMATURE_MAX_ANSWER]; /* text of the last error */
  char out[32768];
  char in[32768];
} armature_client;

/* ---- internals ---- */

static inline int armature_fail_(armature_client* client, int result, const char* what) {
  snprintf(client->error, sizeof client->error, "%s", what);
  return result;
}

static inline int armature_fail_errno_(armature_client* client, const char* what) {
  snprintf(client->error, sizeof client->error, "%s: %s", what, strerror(errno));
  return ARMATURE_LOST;
}

#ifndef MSG_NOSIGNAL
#define MSG_NOSIGNAL 0
#endif

static inline int armature_flush_(armature_client* client) {
  size_t done = 0;
  while (done < client->out_size) {
    const ssize_t bytes = send(client->socket, client->out + done, client->out_size - done, MSG_NOSIGNAL);
    if (bytes < 0 && errno == EINTR) continue;
    if (bytes < 0) return armature_fail_errno_(client, "cannot send to the server");
    done += (size_t)bytes;
  }
  client->out_size = 0;
  return ARMATURE_OK;
}

/* The next line of the server, without its end; valid until the next call. */
static inline int armature_line_(armature_client* client, char** line) {
  for (;;) {
    char* begin = client->in + client->in_begin;
    const size_t size = client->in_end - client->in_begin;
    char* end = (char*)memchr(begin, '\n', size);
    ssize_t bytes;
    if (end != NULL) {
      *end = '\0';
      *line = begin;
      client->in_begin = (size_t)(end + 1 - client->in);
      return ARMATURE_OK;
    }
    if (size >= ARMATURE_MAX_ANSWER) return armature_fail_(client, ARMATURE_LOST, "the server's answer has no end");
    memmove(client->in, begin, size);
    client->in_begin = 0;
    client->in_end = size;
    bytes = recv(client->socket, client->in + size, sizeof client->in - size, 0);
    if (bytes < 0 && errno == EINTR) continue;
    if (bytes < 0) return armature_fail_errno_(client, "cannot receive from the server");
    if (bytes == 0) return armature_fail_(client, ARMATURE_LOST, "the server has closed the connection");
    client->in_end += (size_t)bytes;
  }
}

/* ---- connection ---- */

static inline int armature_connect_(armature_client* client, const char* where) {
  union {
    struct sockaddr any;
    struct sockaddr_in tcp;
    struct sockaddr_un path;
  } name;
  socklen_t size;
  memset(client, 0, sizeof *client);
  memset(&name, 0, sizeof name);
  client->socket = -1;
  if (strncmp(where, "tcp:", 4) == 0) {
    char* end;
    const unsigned long port = strtoul(where + 4, &end, 10);
    if (end == where + 4 || *end != '\0' || port == 0 || port > 65535) {
      return armature_fail_(client, ARMATURE_LOST, "expected a port 1..65535 after tcp:");
    }
    name.tcp.sin_family = AF_INET;
    name.tcp.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    name.tcp.sin_port = htons((uint16_t)port);
    size = sizeof name.tcp;
  } else {
    if (strlen(where) >= sizeof name.path.sun_path) {
      return armature_fail_(client, ARMATURE_LOST, "the path of the socket is too long");
    }
    name.path.sun_family = AF_UNIX;
    memcpy(name.path.sun_path, where, strlen(where));
    size = sizeof name.path;
  }
  client->socket = socket(name.any.sa_family, SOCK_STREAM, 0);
  if (client->socket < 0) return armature_fail_errno_(client, "cannot create a socket");
  if (connect(client->socket, &name.any, size) != 0) {
    const int failed = armature_fail_errno_(client, "cannot connect");
    close(client->socket);
    client->socket = -1;
    return failed;
  }
  if (name.any.sa_family == AF_INET) {
    const int on = 1; /* commands are sent in batches already */
    setsockopt(client->socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  }
  return ARMATURE_OK;
}

static inline void armature_close(armature_client* client) {
  if (client->socket >= 0) close(client->socket);
  client->socket = -1;
}

/* Sends the first line. Reads the answer even if sending fails: a busy server closes the connection after an error
 * line. */
static inline int armature_send_token_(armature_client* client, const char* token) {
  char* line;
  int sent, received;
  const int size = snprintf(client->out, sizeof client->out, "token %s\n", token == NULL ? "" : token);
  if (size < 0 || size > ARMATURE_MAX_LINE || strchr(client->out, '\n') != client->out + size - 1) {
    return armature_fail_(client, ARMATURE_LOST, "the token must be one word");
  }
  client->out_size = (size_t)size;
  sent = armature_flush_(client);
  client->out_size = 0;
  received = armature_line_(client, &line);
  if (received == ARMATURE_OK && strcmp(line, "ok") == 0) return sent;
  if (received == ARMATURE_OK && strncmp(line, "error ", 6) == 0)
    return armature_fail_(client, ARMATURE_LOST, line + 6);
  if (received == ARMATURE_OK) return armature_fail_(client, ARMATURE_LOST, "the answer is neither ok nor error");
  return received;
}

/* `where` as after --listen: "tcp:PORT" or the path of the Unix socket, which needs no token (NULL). Returns
 * ARMATURE_LOST, with the server's reason in `error`, also when it serves another client or the token is wrong. */
static inline int armature_open_with_token(armature_client* client, const char* where, const char* token) {
  int result = armature_connect_(client, where);
  if (result == ARMATURE_OK) result = armature_send_token_(client, token);
  if (result != ARMATURE_OK) armature_close(client);
  return result;
}

/* The same with the token of the environment variable ARMATURE_TOKEN, if there is one. */
static inline int armature_open(armature_client* client, const char* where) {
  return armature_open_with_token(client, where, getenv("ARMATURE_TOKEN"));
}

/* ---- pipelining ---- */

/* Queues one command, written as for printf and without the end of the line. It is sent when the buffer is full or an
 * answer is requested. Returns ARMATURE_REFUSED and queues nothing when the command is too long, is not one line, or
 * too many are in flight. */
#ifdef __GNUC__
__attribute__((format(printf, 2, 3)))
#endif
static inline int
armature_post(armature_client* client, const char* format, ...) {
  char line[ARMATURE_MAX_LINE + 1];
  va_list values;
  int size;
  va_start(values, format);
  size = vsnprintf(line, sizeof line, format, values);
  va_end(values);
  if (client->in_flight >= ARMATURE_MAX_IN_FLIGHT) {
    return armature_fail_(client, ARMATURE_REFUSED, "too many commands in flight: read answers first");
  }
  if (size < 0 || (size_t)size >= sizeof line || memchr(line, '\n', (size_t)size) != NULL) {
    return armature_fail_(client, ARMATURE_REFUSED, "a command is one line of at most 4096 bytes");
  }
  if (client->out_size + (size_t)size + 1 > sizeof client->out) {
    const int result = armature_flush_(client);
    if (result != ARMATURE_OK) return result;
  }
  memcpy(client->out + client->out_size, line, (size_t)size);
  client->out_size += (size_t)size;
  client->out[client->out_size++] = '\n';
  ++client->in_flight;
  return ARMATURE_OK;
}

/* The answer to the oldest command that has none yet. `value` may be NULL; it receives the number after `ok`, decimal
 * or hexadecimal, and is unchanged when there is none. */
static inline int armature_answer(armature_client* client, uint64_t* value) {
  char* line;
  int result;
  if (client->in_flight == 0) return armature_fail_(client, ARMATURE_REFUSED, "no command is in flight");
  result = armature_flush_(client);
  if (result == ARMATURE_OK) result = armature_line_(client, &line);
  if (result != ARMATURE_OK) return result;
  --client->in_flight;
  if (strncmp(line, "error ", 6) == 0) return armature_fail_(client, ARMATURE_REFUSED, line + 6);
  if (strcmp(line, "ok") == 0) return ARMATURE_OK;
  if (strncmp(line, "ok ", 3) != 0) return armature_fail_(client, ARMATURE_LOST, "the answer is neither ok nor error");
  if (value != NULL) *value = strtoull(line + 3, NULL, strncmp(line + 3, "0x", 2) == 0 ? 16 : 10);
  return ARMATURE_OK;
}

/* ---- one command, waiting for its answer ---- */

static inline int armature_wait_(armature_client* client, int posted, uint64_t* value) {
  return posted == ARMATURE_OK ? armature_answer(client, value) : posted;
}

/* One 32-bit read. Takes simulated time. */
static inline int armature_read(armature_client* client, uint32_t addr, uint32_t* value) {
  uint64_t answer = 0;
  const int result = armature_wait_(client, armature_post(client, "r 0x%" PRIX32, addr), &answer);
  if (result == ARMATURE_OK) *value = (uint32_t)answer;
  return result;
}

/* One 32-bit write. Takes simulated time. */
static inline int armature_write(armature_client* client, uint32_t addr, uint32_t data) {
  return armature_wait_(client, armature_post(client, "w 0x%" PRIX32 " 0x%" PRIX32, addr, data), NULL);
}

/* Writes the bytes i of `data` for which bit i of `strobes` (0..15) is 1. */
static inline int armature_write_bytes(armature_client* client, uint32_t addr, uint32_t data, unsigned strobes) {
  return armature_wait_(client, armature_post(client, "w 0x%" PRIX32 " 0x%" PRIX32 " %u", addr, data, strobes), NULL);
}

/* Runs so many clocks of 20 ns, at most 1000000000. `now` may be NULL; it receives the cycle after them. */
static inline int armature_run(armature_client* client, uint64_t cycles, uint64_t* now) {
  return armature_wait_(client, armature_post(client, "run %" PRIu64, cycles), now);
}

/* Runs until a bit of irq_o is high. Returns ARMATURE_REFUSED when none is high within `max_cycles` clocks. */
static inline int armature_run_until_irq(armature_client* client, uint64_t max_cycles, uint64_t* now) {
  return armature_wait_(client, armature_post(client, "run-until-irq %" PRIu64, max_cycles), now);
}

/* Clocks since reset. */
static inline int armature_time(armature_client* client, uint64_t* now) {
  return armature_wait_(client, armature_post(client, "time"), now);
}

/* The level of a pin by the name of the port of arm_soc; bit i for axis i + 1. */
static inline int armature_get_pin(armature_client* client, const char* name, uint32_t* level) {
  uint64_t answer = 0;
  const int result = armature_wait_(client, armature_post(client, "pin %s", name), &answer);
  if (result == ARMATURE_OK) *level = (uint32_t)answer;
  return result;
}

/* Drives an input from the next clock on. */
static inline int armature_set_pin(armature_client* client, const char* name, uint32_t level) {
  return armature_wait_(client, armature_post(client, "pin %s %" PRIu32, name, level), NULL);
}

/* Writes every signal from now on to a file (a name ending in .vcd) below the folder of the server's option
 * --out; NULL or "" closes it. */
static inline int armature_vcd(armature_client* client, const char* file) {
  const int posted =
      file == NULL || *file == '\0' ? armature_post(client, "vcd") : armature_post(client, "vcd %s", file);
  return armature_wait_(client, posted, NULL);
}

#ifdef __cplusplus
}
#endif

#endif
