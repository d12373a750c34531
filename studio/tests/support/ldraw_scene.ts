import {Box3, type Group, LineBasicMaterial, Mesh, MeshStandardMaterial, Vector3} from 'three';
import {LDrawConditionalLineMaterial} from 'three/examples/jsm/materials/LDrawConditionalLineMaterial.js';
import {LDrawLoader} from 'three/examples/jsm/loaders/LDrawLoader.js';

/** A part as three.js stands it in the scene: LDraw's own axes and lengths, -y up. */
export interface StandingPart {
  part: string;
  model: string;
  /** Over all models, in the order of building. */
  step: number;
  color: string;
  /** Of its mesh, in the scene. */
  box: Box3;
  mirrored: boolean;
  /** Which way its studs point. */
  up: Vector3;
}

/** As LDraw's own list of colours would have it. */
function material(code: string): MeshStandardMaterial {
  const own = new MeshStandardMaterial();
  own.userData = {code, edgeMaterial: new LineBasicMaterial()};
  return own;
}

/** An LDraw file that brings its parts along, as another program reads it. */
export async function standingParts(text: string, colors: readonly string[]): Promise<StandingPart[]> {
  const loader = new LDrawLoader();
  loader.setConditionalLineMaterial(LDrawConditionalLineMaterial);
  loader.smoothNormals = false;
  loader.addMaterials(colors.map(material));
  const root = await new Promise<Group>((resolve, reject) => loader.parse(text, resolve, reject));
  root.updateMatrixWorld(true);
  const parts: StandingPart[] = [];
  root.traverse((object) => {
    const {fileName, buildingStep, colorCode} = object.userData as {fileName?: string; buildingStep: number; colorCode: string};
    if (!object.name.endsWith('.dat')) return;
    const meshes = object.children.filter((child): child is Mesh => child instanceof Mesh);
    for (const {material} of meshes)
      for (const each of [material].flat() as MeshStandardMaterial[])
        if (each.userData.code !== colorCode) throw new Error(`${object.name} of ${colorCode} is drawn in ${String(each.userData.code)}`);
    const box = new Box3();
    for (const mesh of meshes) box.union(new Box3().setFromObject(mesh, true));
    parts.push({
      part: (fileName || object.name).replace(/\.dat$/, ''),
      model: object.parent!.name,
      step: buildingStep,
      color: colorCode,
      box,
      mirrored: object.matrixWorld.determinant() < 0,
      up: new Vector3(0, -1, 0).transformDirection(object.matrixWorld),
    });
  });
  return parts;
}
