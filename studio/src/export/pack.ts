import type {OutputFile} from '../engine/api';
import type {Pack} from '../engine/module';
import {writePdf, type Page} from './pdf';
import {zipped} from './zip';

/** The files of a pack as a maker has them: its documents as PDF, its containers (3MF) zipped. */
export async function packFiles(pack: Pack): Promise<OutputFile[]> {
  const files = [...pack.files];
  for (const {name, members} of pack.containers) files.push({name, bytes: zipped(members)});
  for (const {name, title, trueSize, pages} of pack.documents)
    files.push({name: `${name}.pdf`, bytes: await writePdf(title, trueSize, JSON.parse(pages) as Page[])});
  return files;
}
