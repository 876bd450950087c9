# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""WebDriver (https://www.w3.org/TR/webdriver) over chromedriver's HTTP and Firefox's own Marionette.

Debian 12 has no geckodriver. Both classes have call(command, **arguments), which returns the value of the answer.
"""
import http.client
import json
import socket


class WebDriverError(Exception):
    """The browser's answer to a command that failed."""


def refuse(answer):
    raise WebDriverError(f"{answer['error']}: {answer['message']}")


class ChromeDriver:
    """A session of a chromedriver that listens on a port of this machine."""

    # What a command is called in a URL: method and path behind the session's.
    PATHS = {"Navigate": ("POST", "url"), "ExecuteScript": ("POST", "execute/sync"),
             "PerformActions": ("POST", "actions"), "ReleaseActions": ("DELETE", "actions"),
             "FindElement": ("POST", "element"), "SetTimeouts": ("POST", "timeouts"),
             "SwitchToFrame": ("POST", "frame"), "TakeScreenshot": ("GET", "element/{id}/screenshot"),
             "DeleteSession": ("DELETE", ""), "Log": ("POST", "se/log"), "DevTools": ("POST", "goog/cdp/execute")}

    def __init__(self, port, capabilities):
        self.connection = http.client.HTTPConnection("127.0.0.1", port, timeout=600)
        answer = self.request("POST", "/session", {"capabilities": {"alwaysMatch": capabilities}})
        self.session = f"/session/{answer['sessionId']}"

    def request(self, method, path, arguments):
        body = json.dumps(arguments) if method == "POST" else None
        self.connection.request(method, path, body, {"Content-Type": "application/json"})
        value = json.loads(self.connection.getresponse().read())["value"]
        if isinstance(value, dict) and "error" in value:
            refuse(value)
        return value

    def call(self, command, **arguments):
        method, path = self.PATHS[command]
        path = path.format(**arguments)
        return self.request(method, self.session + ("/" + path if path else ""), arguments)

    def close(self):
        self.connection.close()


class Marionette:
    """A session of a Firefox that was started with --marionette: messages are "LENGTH:JSON" over TCP."""

    def __init__(self, port, capabilities):
        self.socket = socket.create_connection(("127.0.0.1", port), timeout=600)
        self.stream = self.socket.makefile("rb")
        self.receive()  # the greeting
        self.number = 0
        self.call("NewSession", capabilities={"alwaysMatch": capabilities})

    def receive(self):
        digits = b""
        while not digits.endswith(b":"):
            byte = self.stream.read(1)
            if not byte:
                raise WebDriverError("Firefox has ended")
            digits += byte
        return json.loads(self.stream.read(int(digits[:-1])))

    def call(self, command, prefix="WebDriver:", **arguments):
        self.number += 1
        message = json.dumps([0, self.number, prefix + command, arguments]).encode()
        self.socket.sendall(b"%d:%s" % (len(message), message))
        _, _, error, result = self.receive()
        if error:
            refuse(error)
        return result["value"] if isinstance(result, dict) and "value" in result else result

    def close(self):
        self.stream.close()
        self.socket.close()
