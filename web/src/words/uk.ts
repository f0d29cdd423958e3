import { en, type Table } from './en';
export const uk: Table = en;
