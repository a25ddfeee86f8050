"""The throughput of a served board: round trips of one host, of fifty, and more.

Connections use the loopback interface. Prints `name value unit`. The server is a separate process; hosts send
`1TP` and wait for the answer and the prompt. Rates are the best of several rounds.
"""

from __future__ import annotations

import selectors
import signal
import socket
import subprocess
import sys
import threading
from time import perf_counter

from motionlang.client import Client

ROUNDS = 3
TRIPS = 5000
HOSTS = 50
SECONDS = 2.0
ANSWER = b"01 0\n>"


def connect(port: int) -> socket.socket:
    """Return the connection of a host, after its first prompt."""
    host = socket.create_connection(("127.0.0.1", port), 20)
    host.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    assert host.recv(1) == b">"
    return host


def one_host(port: int) -> float:
    """Return round trips per second of one host with plain sockets."""
    best = 0.0
    with connect(port) as host:
        for _ in range(ROUNDS):
            begin = perf_counter()
            for _ in range(TRIPS):
                host.sendall(b"1TP\r")
                answer = host.recv(64)
                while len(answer) < len(ANSWER):
                    answer += host.recv(64)
            best = max(best, TRIPS / (perf_counter() - begin))
    return best


def many_hosts(port: int) -> tuple[float, float, float]:
    """Return round trips per second of all hosts, the smallest share and longest wait.

    The share is that of the slowest host relative to the mean; the wait is in seconds.
    """
    hosts = dict.fromkeys((connect(port) for _ in range(HOSTS)), b"")
    counts, sent = dict.fromkeys(hosts, 0), dict.fromkeys(hosts, 0.0)
    longest = 0.0
    with selectors.DefaultSelector() as selector:
        begin = perf_counter()
        for host in hosts:
            selector.register(host, selectors.EVENT_READ, host)
            sent[host] = perf_counter()
            host.sendall(b"1TP\r")
        while (now := perf_counter()) < begin + SECONDS:
            for key, _ in selector.select(1.0):
                host = key.data
                hosts[host] += host.recv(64)
                if hosts[host] == ANSWER:
                    now = perf_counter()
                    longest = max(longest, now - sent[host])
                    hosts[host], sent[host] = b"", now
                    counts[host] += 1
                    host.sendall(b"1TP\r")
    for host in hosts:
        host.close()
    total = sum(counts.values())
    return total / SECONDS, min(counts.values()) * HOSTS / total, longest


def beside_a_busy_program(port: int) -> float:
    """Return round trips per second of a host while another host runs an endless loop."""
    with connect(port) as busy:
        busy.sendall(b"AA1,RP\r")
        rate = one_host(port)
        busy.sendall(b"\x1b")
        busy.recv(64)
    return rate


def client_rate(client: Client) -> float:
    """Return round trips per second through `motionlang.client`."""
    best = 0.0
    for _ in range(ROUNDS):
        begin = perf_counter()
        for _ in range(TRIPS):
            client.send("1TP")
        best = max(best, TRIPS / (perf_counter() - begin))
    return best


def measure(clock: str) -> None:
    """Measure everything on a server whose machine time follows `clock`."""
    command = [sys.executable, "-m", "motionlang", "serve", "--tcp", "0", "--clock", clock]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as server:
        # The server never outlives its measurement.
        guard = threading.Timer(120.0, server.kill)
        guard.start()
        assert server.stdout is not None
        server.stdout.readline()
        port = int(server.stdout.readline().rpartition(":")[2])
        print(f"serve.{clock}.one_host {one_host(port):.0f} round_trips/s")
        total, share, longest = many_hosts(port)
        print(f"serve.{clock}.{HOSTS}_hosts {total:.0f} round_trips/s")
        print(f"serve.{clock}.{HOSTS}_hosts_least_share {share:.3f} of_mean")
        print(f"serve.{clock}.{HOSTS}_hosts_longest_wait {longest * 1e3:.1f} ms")
        print(f"serve.{clock}.beside_a_busy_program {beside_a_busy_program(port):.0f} round_trips/s")
        with Client.tcp("127.0.0.1", port) as client:
            print(f"serve.{clock}.client {client_rate(client):.0f} round_trips/s")
        server.send_signal(signal.SIGTERM)
        server.wait(20)
        guard.cancel()


def main() -> None:
    """Measure and print."""
    for clock in ("real", "lockstep"):
        measure(clock)
    with Client.virtual() as client:
        print(f"client.virtual {client_rate(client):.0f} round_trips/s")


if __name__ == "__main__":
    main()
