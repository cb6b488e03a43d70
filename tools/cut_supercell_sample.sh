#!/bin/sh
# cut_supercell_sample.sh SOURCE TARGET: extracts the bundled storm from a full WRF run of em_quarter_ss.
#
# Keeps four times, the whole grid and the fields that Nephoscope reads. QVAPOR keeps two significant
# digits (at most 0.02 % of the air density), everything else is as in SOURCE. Needs nco and
# netcdf-bin. Each file must stay below 4 MiB.
set -eu
source=$1
target=$2
mkdir -p "$target"
for time in 00:30:00 01:00:00 01:30:00 02:00:00; do
    name=wrfout_d01_0001-01-01_$time
    ncks -O -h -4 -L 9 -x -v W,MU,MUB,RAINNC,PSFC --ppc QVAPOR=2 "$source/$name" "$target/cut.nc"
    nccopy -s -d 9 -c Time/1,bottom_top/15,bottom_top_stag/16,south_north/120,west_east/110 "$target/cut.nc" "$target/$name"
    rm "$target/cut.nc"
    test "$(stat -c %s "$target/$name")" -le 4194304
done
