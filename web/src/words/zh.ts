import { en, type Table } from './en';
export const zh: Table = en;
