import array, math
nx, ny, nz, dx, dy, dz = 40, 30, 20, 100, 100, 50  # cells and metres
values = array.array("f")
for z in range(nz):
    for y in range(ny):
        for x in range(nx):
            r = math.hypot((x - 20) / 15, (y - 15) / 10, (z - 8) / 6)
            values.append(max(0, 0.5 * (1 - r)))  # g/kg
with open("bank.fog", "wb") as out:
    out.write(f"FOG {nx} {ny} {nz} {dx} {dy} {dz}\n".encode())
    values.tofile(out)
