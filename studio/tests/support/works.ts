import type {Work} from '../../src/design/design';
import {startCore} from './snug';

const {words} = (await (await startCore()).options())['workshop.for'];

/** Every way of working that the library has. */
export const WORKS = words as Work[];
