# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""Damage to the bytes of a file: numbers, bytes, cuts. The same random numbers make the same damage."""
import re

NUMBER = re.compile(rb"(?<![\w.])-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
TEXTS = [b"-1", b"0", b"1", b"2", b"3", b"7", b"255", b"65536", b"1000000", b"2147483647", b"-2147483648",
         b"4294967295", b"4294967296", b"9223372036854775807", b"18446744073709551616", b"1e30", b"1e308", b"-1e308",
         b"1e400", b"1e-320", b"nan", b"inf", b"0.5", b"x", b""]
WORDS = [0, 1, 2, 3, 7, 255, 1 << 16, 10 ** 6, (1 << 31) - 1, 1 << 31, (1 << 32) - 1]


def replace_number(data, random):
    numbers = list(NUMBER.finditer(data))
    if not numbers:
        return replace_bytes(data, random)
    at = random.choice(numbers)
    text = random.choice(TEXTS)
    if random.random() < 0.3 and at.group().lstrip(b"-").isdigit():
        text = b"%d" % (int(at.group()) + random.choice((-1, 1, 100)))
    return data[:at.start()] + text + data[at.end():]


def replace_bytes(data, random):
    data = bytearray(data)
    for _ in range(random.choice((1, 1, 2, 8))):
        if data:
            data[random.randrange(len(data))] = random.randrange(256)
    return bytes(data)


def replace_word(data, random):
    size = random.choice((4, 8))
    if len(data) < size:
        return replace_bytes(data, random)
    at = random.randrange(len(data) - size + 1)
    value = random.choice(WORDS) * random.choice((1, 1, (1 << 32) + 1)) % (1 << 8 * size)
    return data[:at] + value.to_bytes(size, random.choice(("little", "big"))) + data[at + size:]


def cut(data, random):
    return data[:random.randrange(len(data) + 1)]


def part_of(data, random):
    begin = random.randrange(len(data) + 1)
    return begin, min(len(data), begin + random.choice((1, 2, 4, 8, 30, 200)))


def remove(data, random):
    begin, end = part_of(data, random)
    return data[:begin] + data[end:]


def repeat(data, random):
    begin, end = part_of(data, random)
    return data[:end] + data[begin:end] * random.choice((1, 1, 2, 100)) + data[end:]


WAYS = (replace_number, replace_number, replace_number, replace_bytes, replace_word, cut, remove, repeat)


def damaged(data, random):
    for _ in range(random.choice((1, 1, 1, 2, 3))):
        data = random.choice(WAYS)(data, random)
    return data
