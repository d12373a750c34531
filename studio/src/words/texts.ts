import {check} from './check';
import {drops} from './drops';
import {failures} from './failures';
import {fields} from './fields';
import {fieldsOf} from './fields_of';
import {files} from './files';
import {first} from './first';
import {foam} from './foam';
import {items} from './items';
import {make} from './make';
import {measure} from './measure';
import {object} from './object';
import {page} from './page';
import {pieces} from './pieces';
import {placement} from './placement';
import {views} from './views';
import {spoken, words} from './words';
import {workshop} from './workshop';
import {zones} from './zones';

/** Every text of the studio. Sentences of the library come from the library. */
export const ALL = words({...page, ...object, ...items, ...foam, ...pieces, ...workshop, ...placement, ...check, ...drops, ...make, ...views, ...files, ...failures, ...fields, ...fieldsOf, ...zones, ...first, ...measure});

export const en = spoken(ALL, 0);
export const ja = spoken(ALL, 1);
export type Texts = typeof en;
