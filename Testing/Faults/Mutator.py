# SPDX-License-Identifier: BSD-3-Clause
"""Damages files: flipped bits, extreme numbers, cuts, repeats, and pieces of other files."""
import re
import struct

# Numbers that often cause errors as sizes, offsets and counts.
WHOLE = [0, 1, 2, 7, 127, 128, 255, 256, 32767, 32768, 65535, 65536, 0x7fffffff, 0x80000000,
         0xffffffff, 0x100000000, 0x7fffffffffffffff, 0x8000000000000000, 0xffffffffffffffff]
REAL = [0.0, -1.0, 1e-320, 1e-40, 1e20, 1e38, 1e300, float("inf"), float("-inf"), float("nan")]
WORDS = [b"0", b"-1", b"1e400", b"1e-400", b"nan", b"inf", b"-inf", b"2147483647", b"2147483648", b"4294967296",
         b"-2147483648", b"9223372036854775807", b"18446744073709551616", b"1e20", b"", b"x",
         b"0x10", b"1,5", b"../x", b"/dev/zero", b"%s%n", b"&amp;", b"<", b"\0"]
NUMBER = re.compile(rb"[-+]?\d+(?:\.\d*)?(?:[eE][-+]?\d+)?")

# The beginning of a file contains most of its structure.
HEADER = 512


def place(rng, content):
    """An offset in the content, half of the time in its beginning."""
    size = len(content) if rng.random() < 0.5 else min(len(content), HEADER)
    return rng.randrange(max(size, 1))


def flip(rng, content, others):
    for _ in range(rng.choice([1, 1, 2, 8, 32])):
        if content:
            content[place(rng, content)] ^= 1 << rng.randrange(8)


def put_number(rng, content, others):
    order = rng.choice("<>")
    size, letter = rng.choice([(1, "B"), (2, "H"), (4, "I"), (8, "Q"), (4, "f"), (8, "d")])
    if letter in "fd":
        value = rng.choice(REAL)
        value = value if letter == "d" or abs(value) < 3e38 or value != value else 3e38
    else:
        value = (rng.choice(WHOLE) + rng.choice([0, 0, 1, -1])) % (1 << (8 * size))
    at = place(rng, content)
    content[at:at + size] = struct.pack(order + letter, value)


def put_word(rng, content, others):
    """In a text format, replaces a number; in a binary one, a number that is stored as text."""
    found = list(NUMBER.finditer(bytes(content)))
    if found:
        one = rng.choice(found)
        content[one.start():one.end()] = rng.choice(WORDS)


def cut(rng, content, others):
    at = place(rng, content)
    del content[at:]


def drop(rng, content, others):
    at = place(rng, content)
    del content[at:at + rng.choice([1, 2, 4, 16, 256])]


def repeat(rng, content, others):
    at = place(rng, content)
    piece = content[at:at + rng.choice([1, 4, 16, 256])]
    content[at:at] = piece * rng.choice([1, 2, 50])


def splice(rng, content, others):
    other = rng.choice(others)
    start, at = place(rng, other), place(rng, content)
    piece = other[start:start + rng.choice([4, 32, 512, len(other)])]
    content[at:at + rng.choice([0, len(piece)])] = piece


OPERATIONS = [flip, flip, put_number, put_number, put_word, put_word, cut, drop, repeat, splice]


def mutate(rng, content, others):
    """A damaged copy of the content. `others`: files of the same format, from which pieces are taken."""
    spoilt = bytearray(content)
    for _ in range(rng.choice([1, 1, 2, 4])):
        rng.choice(OPERATIONS)(rng, spoilt, others)
    return bytes(spoilt)
