"""Files broken at random, the same ones in every run."""

import numpy as np

import manipplan as mp

PIECES = (b"", b"-", b"99999999", b"nan", b"1e30", b"\0", b"\xff\xff\xff\x7f")


def broken_copies(data, count):
    """Copies of a file with one to four places changed, cut out or put in."""
    for seed in range(count):
        rng = np.random.default_rng(seed)
        copy = bytearray(data)
        for _ in range(rng.integers(1, 5)):
            at = int(rng.integers(len(copy)))
            copy[at : at + int(rng.integers(0, 4))] = PIECES[rng.integers(len(PIECES))]
        yield bytes(copy)


def count_refused(file, data, read):
    """How many of 150 broken copies raise FileFormatError, which names the file; what is read has parts to check."""
    refused = 0
    for copy in broken_copies(data, 150):
        file.write_bytes(copy)
        try:
            shape = read(file)
        except mp.errors.FileFormatError as error:
            refused += 1
            assert file.name in str(error)
        else:
            assert shape.parts()
    return refused
