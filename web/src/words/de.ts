import { en, type Table } from './en';
export const de: Table = en;
