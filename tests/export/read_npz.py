"""Compares an archive with the table that `tumble dump --csv` printed, to the bit. Reads with numpy alone.

Usage: read_npz.py ARCHIVE.npz TABLE.csv
"""
import csv
import struct
import sys

import numpy


def main() -> int:
    archive = numpy.load(sys.argv[1], allow_pickle=False)
    ids = {int(body): column for column, body in enumerate(archive["id"])}
    steps = {int(step): row for row, step in enumerate(archive["step"])}
    names = {"position": "xyz", "orientation": "wxyz", "velocity": "xyz", "spin": "xyz"}
    compared = 0
    with open(sys.argv[2], encoding="utf-8") as table:
        for row in csv.DictReader(table):
            at = (steps[int(row["step"])], ids[int(row["id"])])
            if "present" in archive and not archive["present"][at]:
                print(f"{row['step']}, {row['id']}: the archive has no such body")
                return 1
            for field, letters in names.items():
                for k, letter in enumerate(letters):
                    wanted = float(row[f"{field}.{letter}"])
                    found = float(archive[field][at][k])
                    compared += 1
                    if struct.pack("<d", wanted) != struct.pack("<d", found):
                        print(f"{row['step']}, {row['id']}, {field}.{letter}: {found!r}, wanted {wanted!r}")
                        return 1
            if bool(archive["frozen"][at]) != (row["frozen"] == "1"):
                return 1
    present = archive["present"].sum() if "present" in archive else len(ids) * len(steps)
    if compared != 13 * present:
        print(f"compared {compared} numbers of {13 * present}")
        return 1
    return 0


sys.exit(main())
