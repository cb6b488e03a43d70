#!/usr/bin/env python3
"""cut_cumulus_sample.py SOURCE TARGET: extracts the bundled cumulus from CM1's GrADS output of the congestus run.

SOURCE contains cm1out_000001_s.dat to cm1out_000003_s.dat (96 x 90 x 98 cells of 67 m at 540, 720 and 900 s; variables
rain, cref, th, prs, qv, qc, qr, qi, qs, qg). TARGET receives the box around the cloud: cloud water in steps of 0.1 mg/kg
(16 bits); rain, snow and graupel in 255 steps of their maxima, from the time at which they become visible; pressure,
temperature and density of dry air as profiles. The result must stay below 4 MB. Needs numpy.
"""
import json
import pathlib
import sys

import numpy as np

NX, NY, NZ, SPACING_M = 96, 90, 98, 67.0
NAMES = ["th", "prs", "qv", "qc", "qr", "qi", "qs", "qg"]
SECONDS = [540, 720, 900]
X, Y, Z = slice(14, 80), slice(2, 74), slice(13, 84)  # contains all cloud water above 0.1 g/kg
DRY_GAS, VAPOUR, HEAT = 287.04, 461.5, 1005.7  # CM1's constants, J/(kg K)
# name, species, type, number of steps up to the maximum, index of the first time that is kept
FIELDS = [("qc", "cloud", "uint16", None, 0), ("qr", "rain", "uint8", 255, 1),
          ("qs", "snow", "uint8", 255, 2), ("qg", "graupel", "uint8", 255, 1)]


def read(source, i):
    """All fields of time i as (z, y, x) arrays, without the two surface fields."""
    numbers = np.fromfile(source / f"cm1out_{i + 1:06d}_s.dat", "<f4")
    fields = numbers[2 * NX * NY:].reshape(len(NAMES), NZ, NY, NX).astype("f8")
    return dict(zip(NAMES, fields))


def air(times):
    """Profiles of pressure, temperature and dry-air density: means over the horizontal plane and the times."""
    sums = {"prs": 0.0, "temperature": 0.0, "rho": 0.0}
    for t in times:
        temperature = t["th"] * (t["prs"] / 1e5) ** (DRY_GAS / HEAT)
        rho = t["prs"] / (DRY_GAS * temperature * (1.0 + t["qv"] * VAPOUR / DRY_GAS))
        for name, field in (("prs", t["prs"]), ("temperature", temperature), ("rho", rho)):
            sums[name] = sums[name] + field.mean((1, 2)) / len(times)
    # The lowest layer of the brick extends from the ground to cloud base.
    return {name: [p[:Z.start].mean()] + list(p[Z]) for name, p in sums.items()}


def cut(field, step, dtype):
    """The field in the box as multiples of step, x fastest, with one empty level below."""
    numbers = np.rint(field[Z, Y, X] / step)
    return np.concatenate([np.zeros_like(numbers[:1]), numbers]).astype(dtype)


def main(source, target):
    target.mkdir(parents=True, exist_ok=True)
    times = [read(source, i) for i in range(len(SECONDS))]
    variables = []
    for name, species, dtype, steps, first in FIELDS:
        most = max(t[name][Z, Y, X].max() for t in times[first:])
        step = 1e-7 if steps is None else float(f"{most / steps * 1.001:.4g}")
        files = [None] * first
        for seconds, t in list(zip(SECONDS, times))[first:]:
            files.append(f"{name}.{seconds:06d}.raw")
            cut(t[name], step, "<u2" if dtype == "uint16" else "u1").tofile(target / files[-1])
        variables.append({"name": name, "role": "mixing_ratio", "species": species, "unit": "kg/kg", "numbers": dtype,
                          "scale": step, "files": files})
    profiles = air(times)
    for name, role, unit, digits in (("prs", "air_pressure", "Pa", 6), ("temperature", "air_temperature", "K", 5),
                                     ("rho", "dry_air_density", "kg/m3", 5)):
        variables.append({"name": name, "role": role, "unit": unit,
                          "profile": [float(f"{v:.{digits}g}") for v in profiles[name]]})
    sidecar = {
        "type": "nephoscope-brick", "version": 1,
        "model": "CM1 r21.1", "scheme": "Morrison (ptype 5)", "microphysics": "morrison",
        "cloud_droplets_per_m3": 2.5e8,
        "shape": [X.stop - X.start, Y.stop - Y.start, Z.stop - Z.start + 1],
        "spacing_m": [SPACING_M, SPACING_M],
        "interface_heights_m": [0.0] + [SPACING_M * k for k in range(Z.start, Z.stop + 1)],
        "byte_order": "little",
        "times": [{"label": f"{s} s", "seconds": s} for s in SECONDS],
        "variables": variables,
    }
    (target / "cumulus.json").write_text(json.dumps(sidecar, indent=1) + "\n")
    size = sum(f.stat().st_size for f in target.iterdir())
    print(f"{size} bytes")
    assert size <= 4_000_000


main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
