// Writes the npm models as OBJ files into the folder given on the command line: positions with every digit they have,
// vertices and triangles in the package's order.
import { mkdirSync, renameSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import bunny from "bunny";
import teapot from "teapot";

function obj(name, { positions, cells }) {
  const vertices = positions.map((p) => `v ${p.join(" ")}`);
  const faces = cells.map((cell) => `f ${cell.map((index) => index + 1).join(" ")}`);
  return [`o ${name}`, ...vertices, ...faces, ""].join("\n");
}

const folder = process.argv[2];
mkdirSync(folder, { recursive: true });
for (const [name, model] of Object.entries({ bunny, teapot })) {
  const path = join(folder, `${name}.obj`);
  writeFileSync(`${path}.part`, obj(name, model));
  renameSync(`${path}.part`, path);
}
